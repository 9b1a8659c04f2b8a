#include "base/file_pattern.h"

#include <cctype>

#include "base/error.h"

namespace strad {
namespace {

constexpr size_t kMaxDigits = 9;  // an int's

}  // namespace

FilePattern::FilePattern(const std::string& option, const std::string& pattern) {
  const auto refuse = [&](const std::string& why) {
    throw BadInput(option + ": found '" + pattern + "', expected " + why);
  };
  if (pattern.empty()) refuse("a file name");
  for (size_t i = 0; i < pattern.size(); ++i) {
    std::string& text = numbered_ ? after_ : before_;
    if (pattern[i] != '%') {
      text += pattern[i];
      continue;
    }
    if (++i < pattern.size() && pattern[i] == '%') {
      text += '%';
      continue;
    }
    if (numbered_) refuse("only one number such as %04d (a percent sign is %%)");
    numbered_ = true;
    if (i < pattern.size() && pattern[i] == '0') fill_ = '0', ++i;
    for (; i < pattern.size() && std::isdigit(static_cast<unsigned char>(pattern[i])); ++i) {
      width_ = 10 * width_ + static_cast<size_t>(pattern[i] - '0');
      if (width_ > kMaxDigits) refuse("a number of at most 9 digits");
    }
    if (i >= pattern.size() || pattern[i] != 'd')
      refuse("a number written %d, %4d or %04d (a percent sign is %%)");
  }
}

std::string FilePattern::name(int number) const {
  if (!numbered_) return before_;
  const std::string digits = std::to_string(number);
  const std::string padding(width_ > digits.size() ? width_ - digits.size() : 0, fill_);
  return before_ + padding + digits + after_;
}

}  // namespace strad
