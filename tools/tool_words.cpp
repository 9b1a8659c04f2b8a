#include "tool_words.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "base/error.h"
#include "base/utf8.h"

namespace strad {
namespace {

template <typename Number>
bool read_all(std::string_view text, Number* number) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), *number);
  return error == std::errc() && end == text.data() + text.size();
}

// A word, quoted so that a shell reads it as one word.
std::string quoted(std::string word) {
  word = repaired_utf8(word);
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=+,./:@%^";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string result = "'";
  for (const char c : word) {
    if (c == '\'')
      result += "'\\''";
    else
      result += (c >= 0 && c < ' ') || c == 0x7f ? ' ' : c;
  }
  return result + "'";
}

// How many words from `word` on are an option that is left out: 0, 1, or 2 with its value.
int words_left_out(const std::string& word, const std::vector<Unrecorded>& unrecorded) {
  for (const auto& [name, has_value] : unrecorded) {
    if (word == name) return has_value ? 2 : 1;
    const bool is_long = name.starts_with("--");
    if (has_value && word.starts_with(is_long ? name + "=" : name)) return 1;
  }
  return word == "-qv" || word == "-vq" ? 1 : 0;
}

}  // namespace

void fail_option(const std::string& what, std::string_view found, const std::string& expected) {
  throw BadInput(what + ": found '" + std::string(found) + "', expected " + expected);
}

double parse_number(std::string_view text, const std::string& what) {
  double number = 0;
  if (text.ends_with('%') && read_all(text.substr(0, text.size() - 1), &number) && std::isfinite(number)) {
    char fraction[32];
    std::snprintf(fraction, sizeof fraction, "%.6g", number / 100);
    fail_option(what, text, std::string("a plain number: ") + fraction);
  }
  if (!read_all(text, &number) || !std::isfinite(number)) fail_option(what, text, "a number");
  return number;
}

int parse_integer(std::string_view text, const std::string& what) {
  int number = 0;
  if (!read_all(text, &number)) fail_option(what, text, "a whole number");
  return number;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (;;) {
    const size_t end = text.find(separator);
    parts.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::vector<double> parse_numbers(std::string_view text, char separator, const std::string& what) {
  std::vector<double> numbers;
  for (const std::string& part : split(text, separator)) numbers.push_back(parse_number(part, what));
  return numbers;
}

std::vector<int> parse_integers(std::string_view text, char separator, const std::string& what) {
  std::vector<int> numbers;
  for (const std::string& part : split(text, separator)) numbers.push_back(parse_integer(part, what));
  return numbers;
}

double parse_ratio(std::string_view text, const std::string& what) {
  const std::vector<double> parts = parse_numbers(text, '/', what);
  if (parts.size() > 2 || (parts.size() == 2 && !(parts[1] > 0)))
    fail_option(what, text, "a number, or two with / between");
  return parts.size() == 2 ? parts[0] / parts[1] : parts[0];
}

std::array<double, 3> parse_triple(std::string_view text, const std::string& what) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 3) fail_option(what, text, "three numbers with commas between");
  return {parse_number(parts[0], what), parse_number(parts[1], what), parse_number(parts[2], what)};
}

std::string recorded_arguments(int argc, char** argv, const std::vector<Unrecorded>& unrecorded) {
  std::string line;
  for (int i = 1; i < argc; ++i) {
    const int left_out = words_left_out(argv[i], unrecorded);
    if (left_out > 0) {
      i += left_out - 1;
      continue;
    }
    line += " " + quoted(argv[i]);
  }
  return line;
}

}  // namespace strad
