// How a long computation reports its progress.
#pragma once

#include <functional>
#include <string>

namespace strad {

// Called with the fraction done, in [0, 1], and the name of the current step. May be empty: no reports.
using Progress = std::function<void(double, const std::string&)>;

}  // namespace strad
