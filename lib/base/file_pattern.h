// File names with a frame number in them: "room.%04d.exr".
#pragma once

#include <string>

namespace strad {

// A printf pattern with at most one conversion, an integer: %d, %5d or %05d; %% is a percent sign.
class FilePattern {
 public:
  // Throws BadInput beginning with `option` for any other conversion.
  FilePattern(const std::string& option, const std::string& pattern);

  bool numbered() const { return numbered_; }
  std::string name(int number) const;

  // What stands around the number, and how it is filled to its least width.
  const std::string& before() const { return before_; }
  const std::string& after() const { return after_; }
  char fill() const { return fill_; }
  size_t width() const { return width_; }

 private:
  std::string before_, after_;
  bool numbered_ = false;
  char fill_ = ' ';
  size_t width_ = 0;
};

}  // namespace strad
