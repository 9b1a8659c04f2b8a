// Makes PNG files with libpng alone, without loading OpenImageIO.
#pragma once

#include <string>

#include "image/image.h"

namespace strad {

// The bytes of the file: 8 bits on the sRGB curve. Throws IoError.
std::string encode_png(const Image& image);

}  // namespace strad
