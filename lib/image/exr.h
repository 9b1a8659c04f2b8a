// OpenEXR files, written without the many libraries that other formats ask for.
#pragma once

#include <string>

#include "image/image.h"

namespace strad {

// Half floats, ZIP. What went wrong, or nothing.
std::string write_exr(const std::string& path, const Image& image);

}  // namespace strad
