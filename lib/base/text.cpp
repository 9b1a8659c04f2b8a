// Text files written by other programs.
#include "base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>

#include "base/error.h"
#include "base/files.h"
#include "base/utf8.h"

namespace strad {
namespace {

constexpr size_t kLongestText = size_t{4} << 30;

bool is_text(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x20 ? byte != 0x7f : byte >= '\t' && byte <= '\r';
}

// Throws BadInput at the first byte that no text has. `offset` is that of `block` in the file.
void check_text(std::string_view block, size_t offset, const std::string& name) {
  for (size_t i = 0; i < block.size(); ++i) {
    if (!is_text(block[i]))
      throw BadInput(name + ": is not a text file: byte " +
                     std::to_string(static_cast<unsigned char>(block[i])) + " at offset " +
                     std::to_string(offset + i));
  }
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

}  // namespace

std::string text_name(const std::string& path) { return path == "-" ? "standard input" : path; }

std::string path_beside(const std::string& path, const std::string& reference) {
  const std::filesystem::path wanted(reference);
  if (path == "-" || wanted.is_absolute()) return reference;
  return (std::filesystem::path(path).parent_path() / wanted).string();
}

std::string read_text(const std::string& path) {
  const std::string name = text_name(path);
  std::string text;
  // Checked block by block, so that a device that never ends (/dev/zero) is refused at once.
  read_blocks(path, "a text file", [&](std::string_view block) {
    const size_t begin = text.size();
    text += block;
    if (begin < 2 && (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")))
      throw BadInput(name + ": is UTF-16 text, expected ASCII or UTF-8");
    check_text(block, begin, name);
    if (text.size() > kLongestText) throw BadInput(name + ": is longer than 4 GiB");
  });
  if (text.empty()) throw BadInput(name + ": is empty");
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
  return text;
}

void fail_at(const std::string& name, uint32_t line, const std::string& what) {
  throw BadInput(name + ":" + std::to_string(line) + ": " + what);
}

std::string in_quotes(std::string_view text, size_t most) {
  std::string shown = "\"";
  for (size_t left = most; left > 0 && !text.empty();) {
    const size_t length = std::max<size_t>(utf8_length(text), 1);
    if (length > left) break;  // no half characters
    const bool is_shown = utf8_length(text) > 0 && is_text(text[0]) && (length > 1 || text[0] >= ' ');
    shown += is_shown ? text.substr(0, length) : "?";
    text.remove_prefix(length);
    left -= length;
  }
  return shown + (text.empty() ? "\"" : "...\"");
}

std::optional<double> number_in(std::string_view text) {
  size_t first = 0;
  if (text.starts_with('+')) {
    text.remove_prefix(1);
  } else if (text.starts_with('-')) {
    first = 1;
  }
  if (first == text.size() || !(std::isdigit(static_cast<unsigned char>(text[first])) || text[first] == '.'))
    return {};
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size()) return {};
  // from_chars leaves `value` alone where the number is too small or too large for a double.
  if (error == std::errc::result_out_of_range)
    return text.find("e-") != text.npos ? std::optional(0.0) : std::nullopt;
  if (error != std::errc{} || !(std::abs(value) <= std::numeric_limits<float>::max())) return {};
  return value;
}

std::optional<int64_t> integer_in(std::string_view text) {
  int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string_view next_word(std::string_view* rest) {
  size_t begin = 0;
  while (begin < rest->size() && is_blank((*rest)[begin])) ++begin;
  size_t end = begin;
  while (end < rest->size() && !is_blank((*rest)[end])) ++end;
  const std::string_view word = rest->substr(begin, end - begin);
  rest->remove_prefix(end);
  return word;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string single_spaced(std::string_view text) {
  std::string words;
  for (std::string_view word = next_word(&text); !word.empty(); word = next_word(&text))
    words.append(words.empty() ? "" : " ").append(word);
  return words;
}

std::string_view LineReader::take_physical() {
  const size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
  const std::string_view line = rest_.substr(0, end);
  const size_t skip = rest_.substr(end).starts_with("\r\n") ? 2 : 1;
  rest_.remove_prefix(std::min(end + skip, rest_.size()));
  ++taken_;
  return trimmed(line);
}

bool LineReader::next() {
  if (rest_.empty()) return false;
  line_ = take_physical();
  number_ = taken_;
  if (line_.starts_with('#') || !line_.ends_with('\\')) return true;
  joined_.clear();
  while (line_.ends_with('\\') && !rest_.empty()) {
    joined_.append(line_.substr(0, line_.size() - 1)).push_back(' ');
    line_ = take_physical();
  }
  joined_.append(line_.ends_with('\\') ? line_.substr(0, line_.size() - 1) : line_);
  line_ = trimmed(joined_);
  return true;
}

}  // namespace strad
