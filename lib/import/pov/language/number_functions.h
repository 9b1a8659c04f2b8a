// POV-Ray's functions of numbers alone: its own, and those that functions.inc takes from inside POV-Ray.
#pragma once

#include <span>
#include <string_view>

namespace strad {

struct PovNumberFunction {
  std::string_view name;
  size_t least, most;  // arguments
  double (*call)(std::span<const double>);
};

// Null if POV-Ray has none of this name.
const PovNumberFunction* pov_number_function(std::string_view name);

// That of `internal(number)`, which functions.inc gives a name. Null if it is not known here.
const PovNumberFunction* pov_internal_function(int number);

// Its values are not POV-Ray's.
bool is_noise(const PovNumberFunction& function);

}  // namespace strad
