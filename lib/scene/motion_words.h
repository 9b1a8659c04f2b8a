// A motion file as lines of words. Every error names file and line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/vec.h"

namespace strad {

// Behind an angle: it is in radians, not degrees.
constexpr std::string_view kRadians = "rad";

struct MotionLine {
  int number = 0;         // from 1
  bool indented = false;  // belongs to the block above
  std::vector<std::string> words;
};

// The lines that hold words, without comments. Blanks separate words; a word in double quotes may hold blanks
// and #.
std::vector<MotionLine> motion_lines(std::string_view text, const std::string& file);

// Throws BadInput "file:line: found ..., expected ..."; without the line where it is 0.
[[noreturn]] void fail_at(const std::string& file, int line, const std::string& found,
                          const std::string& expected);

// Takes the words of a line one by one.
class MotionWords {
 public:
  MotionWords(const std::string& file, const MotionLine& line) : file_(file), line_(line) {}

  int line() const { return line_.number; }
  bool at_end() const { return next_ == line_.words.size(); }
  std::string word(const std::string& expected);
  double number(const std::string& expected);
  // In radians. Degrees, or a number of radians with `rad` behind it.
  double angle(const std::string& expected);
  // A number, or two with a slash between, the second above 0: 24000/1001.
  double ratio(const std::string& expected);
  Vec3 vector(const std::string& what);
  void expect_end() const;

  // Throws BadInput about the word taken last, or about `found`.
  [[noreturn]] void fail(const std::string& expected) const;
  [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

 private:
  double number_of(std::string_view text, const std::string& expected) const;

  const std::string& file_;
  const MotionLine& line_;
  size_t next_ = 0;
};

}  // namespace strad
