// Values of POV-Ray's language: numbers, strings, arrays, macros, and those that only the interpreter's user
// knows.
#pragma once

#include <any>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "import/pov/language/tokens.h"
#include "import/report.h"

namespace strad {

// A place in a file.
struct PovPlace {
  std::string file;
  uint32_t line = 0;
};
// Something that cannot be imported. It is refused only where it is used.
struct PovProblem {
  std::string what;
  PovPlace place;
};

// Throws BadInput, or with options.skip_unknown reports that it is left out.
void refuse(const PovProblem& problem, const SkipOptions& options, ImportReport* report);

// A number, a vector or a colour (red, green, blue, filter, transmit).
struct PovNumbers {
  int size = 1;  // 1 to 5
  std::array<double, 5> parts{};
  double operator[](int i) const { return parts[static_cast<size_t>(i)]; }
  double& operator[](int i) { return parts[static_cast<size_t>(i)]; }
};

inline PovNumbers number_of(double value) {
  PovNumbers numbers;
  numbers[0] = value;
  return numbers;
}

// A number becomes a vector with that number in each part.
inline PovNumbers promoted(PovNumbers from, int size) {
  if (from.size == 1)
    for (int i = 1; i < size; ++i) from[i] = from[0];
  if (from.size < size) from.size = size;
  return from;
}

struct PovMacro {
  std::shared_ptr<const PovFile> file;
  size_t body = 0;  // first token
  std::vector<std::string> parameters;
};

// function (x, y) { ... }, as the tokens of its body.
struct PovFunction {
  std::shared_ptr<const PovFile> file;
  size_t body = 0;  // first token after {
  std::vector<std::string> parameters;
  std::shared_ptr<const std::any> thing;  // of function { transform { ... } }: what it does to a vector
  std::string unknown;                    // why it cannot be called, such as "pigment"; empty if it can
  const struct PovNumberFunction* native = nullptr;  // internal { ... }
  std::shared_ptr<const struct PovProgram> program;  // the body, if that could be compiled
  std::shared_ptr<const struct PovSpline> spline;    // function { spline { ... } }
  // Names in the body have the values that they had where the function was declared.
  std::shared_ptr<const struct PovBindings> names;
};

// spline { type t, vector, ... }, in the order of t.
struct PovSpline {
  std::string type;  // linear_spline, quadratic_spline, cubic_spline or natural_spline
  std::vector<std::pair<double, PovNumbers>> points;
};

// Declared, but of no use here: an interior, a normal.
struct PovIgnored {};

// std::any holds what PovStatements::describe returns.
struct PovArray;
using PovValue = std::variant<PovIgnored, PovNumbers, std::string, std::shared_ptr<PovArray>, PovMacro,
                              PovFunction, PovSpline, std::any>;

struct PovArray {
  std::vector<size_t> sizes;                   // of each dimension
  std::vector<std::optional<PovValue>> items;  // the last index runs fastest
  size_t depth = 1;                            // of arrays and functions within each other
};

struct PovBindings {
  std::map<std::string, PovValue, std::less<>> values;
  size_t depth = 1;  // as of an array
};

// How deep arrays and functions are within each other in the value: 0 if it is neither.
inline size_t depth_of(const PovValue& value) {
  if (const auto* array = std::get_if<std::shared_ptr<PovArray>>(&value)) return (*array)->depth;
  const auto* function = std::get_if<PovFunction>(&value);
  return function && function->names ? function->names->depth : 0;
}

template <typename T, typename... Kinds>
constexpr bool is_kind_of(const std::variant<Kinds...>*) {
  return (std::is_same_v<T, Kinds> || ...);
}

// The value as a T, or null if it is of another type.
template <typename T>
const T* thing_in(const PovValue& value) {
  if constexpr (is_kind_of<T>(static_cast<PovValue*>(nullptr))) {
    return std::get_if<T>(&value);
  } else {
    return std::any_cast<T>(std::get_if<std::any>(&value));
  }
}

}  // namespace strad
