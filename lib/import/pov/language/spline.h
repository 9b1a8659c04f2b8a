// Points between those of a POV-Ray spline.
#pragma once

#include <string>
#include <string_view>

#include "import/pov/language/values.h"

namespace strad {

bool is_spline_type(std::string_view word);

// The vector at `time`, as POV-Ray 3.7 interpolates. Beyond the ends it is that of the end.
// REQUIRES: is_spline_type(type), and the spline has a point.
PovNumbers spline_at(const PovSpline& spline, const std::string& type, double time);

}  // namespace strad
