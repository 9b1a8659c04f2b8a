#include "import/pov/language/number_functions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/pose.h"
#include "import/pov/language/noise.h"

namespace strad {
namespace {

using Numbers = std::span<const double>;

constexpr std::array<PovNumberFunction, 28> kFunctions{{
    {"abs", 1, 1, [](Numbers a) { return std::abs(a[0]); }},
    {"acos", 1, 1, [](Numbers a) { return std::acos(a[0]); }},
    {"acosh", 1, 1, [](Numbers a) { return std::acosh(a[0]); }},
    {"asin", 1, 1, [](Numbers a) { return std::asin(a[0]); }},
    {"asinh", 1, 1, [](Numbers a) { return std::asinh(a[0]); }},
    {"atan", 1, 1, [](Numbers a) { return std::atan(a[0]); }},
    {"atan2", 2, 2, [](Numbers a) { return std::atan2(a[0], a[1]); }},
    {"ceil", 1, 1, [](Numbers a) { return std::ceil(a[0]); }},
    {"cos", 1, 1, [](Numbers a) { return std::cos(a[0]); }},
    {"cosh", 1, 1, [](Numbers a) { return std::cosh(a[0]); }},
    {"degrees", 1, 1, [](Numbers a) { return a[0] / kDegree; }},
    {"div", 2, 2, [](Numbers a) { return std::trunc(a[0] / a[1]); }},
    {"exp", 1, 1, [](Numbers a) { return std::exp(a[0]); }},
    {"floor", 1, 1, [](Numbers a) { return std::floor(a[0]); }},
    {"int", 1, 1, [](Numbers a) { return std::trunc(a[0]); }},
    {"log", 1, 1, [](Numbers a) { return std::log10(a[0]); }},
    {"ln", 1, 1, [](Numbers a) { return std::log(a[0]); }},
    {"max", 1, 100, [](Numbers a) { return *std::max_element(a.begin(), a.end()); }},
    {"min", 1, 100, [](Numbers a) { return *std::min_element(a.begin(), a.end()); }},
    {"mod", 2, 2, [](Numbers a) { return std::fmod(a[0], a[1]); }},
    {"pow", 2, 2, [](Numbers a) { return std::pow(a[0], a[1]); }},
    {"radians", 1, 1, [](Numbers a) { return a[0] * kDegree; }},
    {"select", 3, 4,
     [](Numbers a) {
       return a.size() == 3 ? a[a[0] < 0 ? 1 : 2] : a[a[0] < 0 ? 1 : a[0] > 0 ? 3 : 2];
     }},
    {"sin", 1, 1, [](Numbers a) { return std::sin(a[0]); }},
    {"sinh", 1, 1, [](Numbers a) { return std::sinh(a[0]); }},
    {"sqrt", 1, 1, [](Numbers a) { return std::sqrt(a[0]); }},
    {"tan", 1, 1, [](Numbers a) { return std::tan(a[0]); }},
    {"tanh", 1, 1, [](Numbers a) { return std::tanh(a[0]); }},
}};

// The first three arguments are a point; those that follow are as functions.inc says.
Vec3 point(Numbers a) { return {a[0], a[1], a[2]}; }

double torus(Numbers a) { return std::hypot(std::hypot(a[0], a[2]) - a[3], a[1]) - a[4]; }

double rounded_box(Numbers a) {
  const double radius = a[3];
  const auto beyond = [&](size_t i) { return std::max(0.0, std::abs(a[i]) - (a[4 + i] - radius)); };
  return length(Vec3{beyond(0), beyond(1), beyond(2)}) - radius;
}

double superellipsoid(Numbers a) {
  const double east = a[3], north = a[4];
  const double around = std::pow(std::abs(a[0]), 2 / east) + std::pow(std::abs(a[1]), 2 / east);
  return 1 - std::pow(std::pow(around, east / north) + std::pow(std::abs(a[2]), 2 / north), north / 2);
}

double ellipsoid(Numbers a) { return length(Vec3{a[0] * a[3], a[1] * a[4], a[2] * a[5]}); }

double noise(Numbers a) { return noise_at(point(a)); }

struct Internal {
  int number;
  PovNumberFunction function;
};
constexpr std::array<Internal, 10> kInternal{{
    {17, {"f_ellipsoid", 6, 6, ellipsoid}},
    {47, {"f_ph", 3, 3, [](Numbers a) { return std::atan2(std::hypot(a[0], a[2]), a[1]); }}},
    {57, {"f_r", 3, 3, [](Numbers a) { return length(point(a)); }}},
    {60, {"f_rounded_box", 7, 7, rounded_box}},
    {61, {"f_sphere", 4, 4, [](Numbers a) { return length(point(a)) - a[3]; }}},
    {68, {"f_superellipsoid", 5, 5, superellipsoid}},
    {69, {"f_th", 3, 3, [](Numbers a) { return std::atan2(a[0], a[2]); }}},
    {70, {"f_torus", 5, 5, torus}},
    {76, {"f_noise3d", 3, 3, noise}},
    {78, {"f_noise_generator", 4, 4, noise}},
}};

}  // namespace

const PovNumberFunction* pov_number_function(std::string_view name) {
  for (const PovNumberFunction& known : kFunctions)
    if (known.name == name) return &known;
  return nullptr;
}

const PovNumberFunction* pov_internal_function(int number) {
  for (const Internal& known : kInternal)
    if (known.number == number) return &known.function;
  return nullptr;
}

bool is_noise(const PovNumberFunction& function) { return function.call == noise; }

}  // namespace strad
