// A motion file as lines of words.
#include "scene/motion_words.h"

#include "base/error.h"
#include "base/text.h"

namespace strad {
namespace {

// Numbers above this are refused, so that squares and products of lengths stay finite in single precision
// too.
constexpr double kLargestNumber = 1e15;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

// Takes the quoted word that begins at line[begin], a quote; returns the place after its closing quote.
size_t take_quoted(std::string_view line, size_t begin, int number, const std::string& file,
                   std::string& word) {
  const size_t close = line.find('"', begin + 1);
  if (close == std::string_view::npos) fail_at(file, number, "end of line", "a closing quote");
  word = line.substr(begin + 1, close - begin - 1);
  if (close + 1 < line.size() && !is_blank(line[close + 1]) && line[close + 1] != '#')
    fail_at(file, number, in_quotes(line.substr(close + 1)), "a blank after the closing quote");
  return close + 1;
}

std::vector<std::string> words_of(std::string_view line, int number, const std::string& file) {
  std::vector<std::string> words;
  size_t i = 0;
  while (i < line.size() && line[i] != '#') {
    if (is_blank(line[i])) {
      ++i;
      continue;
    }
    std::string& word = words.emplace_back();
    if (line[i] == '"') {
      i = take_quoted(line, i, number, file, word);
      continue;
    }
    while (i < line.size() && !is_blank(line[i]) && line[i] != '#') word += line[i++];
  }
  return words;
}

}  // namespace

void fail_at(const std::string& file, int line, const std::string& found, const std::string& expected) {
  const std::string place = line > 0 ? file + ":" + std::to_string(line) : file;
  throw BadInput(place + ": found " + found + ", expected " + expected);
}

std::vector<MotionLine> motion_lines(std::string_view text, const std::string& file) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::vector<MotionLine> lines;
  for (int number = 1; !text.empty(); ++number) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    if (line.find('\0') != std::string_view::npos)
      fail_at(file, number, "a zero byte", "a motion file, which is text");
    std::vector<std::string> words = words_of(line, number, file);
    if (!words.empty()) lines.push_back({number, is_blank(line.front()), std::move(words)});
  }
  return lines;
}

std::string MotionWords::word(const std::string& expected) {
  if (at_end()) fail("end of line", expected);
  return line_.words[next_++];
}

double MotionWords::number(const std::string& expected) { return number_of(word(expected), expected); }

double MotionWords::number_of(std::string_view text, const std::string& expected) const {
  const std::optional<double> value = number_in(text);
  if (!value) fail(expected);
  if (!(std::abs(*value) <= kLargestNumber)) fail("a number of at most 1e15");
  return *value;
}

double MotionWords::angle(const std::string& expected) {
  const std::string text = word(expected);
  if (!text.ends_with(kRadians)) return number_of(text, expected) * kDegree;
  return number_of(std::string_view(text).substr(0, text.size() - kRadians.size()), expected);
}

double MotionWords::ratio(const std::string& expected) {
  const std::string text = word(expected);
  const size_t slash = text.find('/');
  const double above = number_of(text.substr(0, slash), expected);
  if (slash == std::string::npos) return above;
  const double below = number_of(text.substr(slash + 1), expected);
  if (!(below > 0)) fail(expected);
  return above / below;
}

Vec3 MotionWords::vector(const std::string& what) {
  const std::string expected = "the three numbers of " + what;
  const double x = number(expected), y = number(expected), z = number(expected);
  return {x, y, z};
}

void MotionWords::expect_end() const {
  if (!at_end()) fail(in_quotes(line_.words[next_]), "end of line");
}

void MotionWords::fail(const std::string& expected) const {
  fail(in_quotes(line_.words[next_ - 1]), expected);
}

void MotionWords::fail(const std::string& found, const std::string& expected) const {
  fail_at(file_, line_.number, found, expected);
}

}  // namespace strad
