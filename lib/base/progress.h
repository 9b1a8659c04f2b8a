// How long work says how far it is.
#pragma once

#include <functional>
#include <string>

namespace strad {

// Called with the fraction done, in [0, 1], and what is being done. Empty: nobody wants to know.
using Progress = std::function<void(double, const std::string&)>;

}  // namespace strad
