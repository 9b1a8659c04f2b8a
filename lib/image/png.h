// Writes PNG files with libpng alone, without loading OpenImageIO.
#pragma once

#include <string>

#include "image/image.h"

namespace strad {

// 8 bits on the sRGB curve. Returns an error message, empty for success.
std::string write_png(const std::string& path, const Image& image);

}  // namespace strad
