// Text as POV-Ray reads it: numbers, colours, identifiers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/pose.h"
#include "base/rgb.h"
#include "base/vec.h"

namespace strad {

// Appends to a string; quick, since a frame may hold a million numbers.
class PovText {
 public:
  explicit PovText(size_t reserve = 0) { text_.reserve(reserve); }

  PovText& operator<<(std::string_view text) {
    text_ += text;
    return *this;
  }
  PovText& operator<<(const char* text) { return *this << std::string_view(text); }
  PovText& operator<<(double number);  // the fewest digits that read back as the same double
  PovText& operator<<(float number);   // the same of a float
  PovText& operator<<(uint32_t number);
  PovText& operator<<(int number);
  PovText& operator<<(size_t number);
  PovText& operator<<(Vec3 vector);       // <x,y,z> of floats, as meshes hold them
  PovText& operator<<(Rgb colour);        // <r,g,b> of five significant digits
  PovText& exact(Vec3 vector);            // <x,y,z> of doubles
  PovText& operator<<(const Pose& pose);  // matrix <...>

  std::string take() { return std::move(text_); }

 private:
  void short_number(float number);

  std::string text_;
};

// Names as identifiers: all characters but letters, digits and _ become _; of equal ones the later get _2, _3
// and so on.
std::vector<std::string> pov_identifiers(const std::vector<std::string>& names);

}  // namespace strad
