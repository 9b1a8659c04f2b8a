// Makes OpenEXR files with OpenEXR alone, without loading OpenImageIO.
#pragma once

#include <string>

#include "image/image.h"

namespace strad {

// The bytes of the file: half floats, ZIP compression. Throws IoError.
std::string encode_exr(const Image& image);

}  // namespace strad
