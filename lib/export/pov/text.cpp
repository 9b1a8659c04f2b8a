#include "export/pov/text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <set>

namespace strad {
namespace {

template <class Number>
void append_number(Number number, std::string* text) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, number).ptr;
  text->append(buffer, end);
}

// 10^-45 to 10^50, to scale any float to five digits.
constexpr int kLowestPower = -45, kHighestPower = 50;
const std::array<double, kHighestPower - kLowestPower + 1> kPowersOfTen = [] {
  std::array<double, kHighestPower - kLowestPower + 1> powers{};
  for (int p = kLowestPower; p <= kHighestPower; ++p) powers[p - kLowestPower] = std::pow(10.0, p);
  return powers;
}();
double power_of_ten(int p) { return kPowersOfTen[p - kLowestPower]; }

}  // namespace

PovText& PovText::operator<<(double number) { return append_number(number, &text_), *this; }
PovText& PovText::operator<<(float number) { return append_number(number, &text_), *this; }
PovText& PovText::operator<<(uint32_t number) { return append_number(number, &text_), *this; }
PovText& PovText::operator<<(int number) { return append_number(number, &text_), *this; }
PovText& PovText::operator<<(size_t number) { return append_number(number, &text_), *this; }

PovText& PovText::operator<<(Vec3 v) {
  *this << "<" << static_cast<float>(v.x) << "," << static_cast<float>(v.y) << "," << static_cast<float>(v.z)
        << ">";
  return *this;
}

PovText& PovText::exact(Vec3 v) { return *this << "<" << v.x << "," << v.y << "," << v.z << ">"; }

PovText& PovText::operator<<(const Pose& pose) {
  *this << "matrix <";
  for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    const Vec3 row = rotate(pose, axis);  // POV-Ray multiplies rows from the left
    *this << row.x << "," << row.y << "," << row.z << ", ";
  }
  return *this << pose.translation.x << "," << pose.translation.y << "," << pose.translation.z << ">";
}

// Digits and a power of ten, 12345e-4: four times quicker than std::to_chars of five digits.
void PovText::short_number(float number) {
  if (!(std::abs(number) > 1e-30f)) {
    text_ += '0';
    return;
  }
  // The decimal exponent from floor(log2): at most one too low.
  const int power = static_cast<int>(std::floor(std::ilogb(number) * 0.30102999566));
  double digits = number * power_of_ten(4 - power);
  int exponent = power - 4;
  if (std::abs(digits) >= 99999.5) {
    digits /= 10;
    ++exponent;
  }
  append_number(std::lround(digits), &text_);
  if (exponent == 0) return;
  text_ += 'e';
  append_number(exponent, &text_);
}

PovText& PovText::operator<<(Rgb colour) {
  text_ += '<';
  short_number(colour.r);
  text_ += ',';
  short_number(colour.g);
  text_ += ',';
  short_number(colour.b);
  text_ += '>';
  return *this;
}

std::vector<std::string> pov_identifiers(const std::vector<std::string>& names) {
  std::vector<std::string> identifiers;
  std::set<std::string> taken;
  for (const std::string& name : names) {
    std::string identifier = name;
    for (char& c : identifier) {
      const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
      if (!plain) c = '_';
    }
    std::string unique = identifier;
    for (int i = 2; !taken.insert(unique).second; ++i) unique = identifier + "_" + std::to_string(i);
    identifiers.push_back(unique);
  }
  return identifiers;
}

}  // namespace strad
