#include "image/sequence.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "base/error.h"

namespace strad {
namespace {

namespace fs = std::filesystem;

// A pattern taken apart: before, the number padded to `width`, after.
struct Pattern {
  std::string before, after;
  size_t width = 0;
  char pad = ' ';
};

[[noreturn]] void refuse(const std::string& pattern) {
  throw BadInput(pattern + ": expected one number such as %04d in the name");
}

Pattern parse(const std::string& text) {
  Pattern pattern;
  bool found = false;
  for (size_t i = 0; i < text.size(); ++i) {
    std::string& part = found ? pattern.after : pattern.before;
    if (text[i] != '%') {
      part.push_back(text[i]);
    } else if (i + 1 < text.size() && text[i + 1] == '%') {
      part.push_back(text[++i]);
    } else {
      if (found) refuse(text);
      found = true;
      const size_t d = text.find_first_not_of("0123456789", i + 1);
      if (d == std::string::npos || text[d] != 'd' || d > i + 3) refuse(text);
      if (text[i + 1] == '0') pattern.pad = '0';
      std::from_chars(text.data() + i + 1, text.data() + d, pattern.width);
      i = d;
    }
  }
  if (!found) refuse(text);
  return pattern;
}

}  // namespace

bool is_pattern(const std::string& path) { return path.find('%') != std::string::npos; }

std::string frame_path(const std::string& text, int number) {
  const Pattern pattern = parse(text);
  std::string digits = std::to_string(number);
  if (digits.size() < pattern.width) digits.insert(0, pattern.width - digits.size(), pattern.pad);
  return pattern.before + digits + pattern.after;
}

std::vector<int> frames_on_disk(const std::string& text) {
  const Pattern pattern = parse(text);
  const fs::path before = pattern.before;
  const std::string head = before.filename().string();
  if (pattern.after.find('/') != std::string::npos)
    throw BadInput(text + ": expected the number in the file's name, not in a folder's");
  std::error_code error;
  std::vector<int> numbers;
  const fs::path folder = before.has_parent_path() ? before.parent_path() : fs::path(".");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.size() <= head.size() + pattern.after.size() || !name.starts_with(head)) continue;
    int number = 0;
    const char* digits = name.data() + head.size();
    while (*digits == ' ') ++digits;
    std::from_chars(digits, name.data() + name.size(), number);
    if (number >= 0 && fs::path(frame_path(text, number)).filename() == name) numbers.push_back(number);
  }
  if (error) throw IoError(folder.string() + ": " + error.message());
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

}  // namespace strad
