// A motion file as lines of words.
#include "scene/motion_words.h"

#include <charconv>

#include "base/error.h"

namespace strad {
namespace {

// Numbers above this are refused, so that squares and products of lengths stay finite in single precision
// too.
constexpr double kLargestNumber = 1e15;
// Longest part of a word that a message repeats.
constexpr size_t kShownLength = 40;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

// Takes the quoted word that begins at line[begin], a quote; returns the place after its closing quote.
size_t take_quoted(std::string_view line, size_t begin, int number, const std::string& file,
                   std::string& word) {
  const size_t close = line.find('"', begin + 1);
  if (close == std::string_view::npos) fail_at(file, number, "end of line", "a closing quote");
  word = line.substr(begin + 1, close - begin - 1);
  if (close + 1 < line.size() && !is_blank(line[close + 1]) && line[close + 1] != '#')
    fail_at(file, number, quoted(line.substr(close + 1)), "a blank after the closing quote");
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
  throw BadInput(file + ":" + std::to_string(line) + ": found " + found + ", expected " + expected);
}

std::string quoted(std::string_view word) {
  constexpr char kHex[] = "0123456789abcdef";
  std::string shown = "\"";
  for (const char c : word.substr(0, kShownLength)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f)
      shown += {'\\', 'x', kHex[byte >> 4], kHex[byte & 15]};
    else
      shown += c;
  }
  if (word.size() > kShownLength) shown += "...";
  return shown + "\"";
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

double MotionWords::number(const std::string& expected) {
  const std::string text = word(expected);
  const char *begin = text.data(), *end = begin + text.size();
  // from_chars takes no plus sign; one is fine, a second is not.
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') ++begin;
  double value = 0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  const bool whole = stop == end && error == std::errc();
  if (!whole || !std::isfinite(value)) fail(expected);
  if (!(std::abs(value) <= kLargestNumber)) fail("a number of at most 1e15");
  return value;
}

Vec3 MotionWords::vector(const std::string& what) {
  const std::string expected = "the three numbers of " + what;
  const double x = number(expected), y = number(expected), z = number(expected);
  return {x, y, z};
}

void MotionWords::expect_end() const {
  if (!at_end()) fail(quoted(line_.words[next_]), "end of line");
}

void MotionWords::fail(const std::string& expected) const { fail(quoted(line_.words[next_ - 1]), expected); }

void MotionWords::fail(const std::string& found, const std::string& expected) const {
  fail_at(file_, line_.number, found, expected);
}

}  // namespace strad
