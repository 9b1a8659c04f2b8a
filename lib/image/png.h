// PNG files, written without the many libraries that other formats ask for.
#pragma once

#include <string>

#include "image/image.h"

namespace strad {

// 8 bits on the sRGB curve. What went wrong, or nothing.
std::string write_png(const std::string& path, const Image& image);

}  // namespace strad
