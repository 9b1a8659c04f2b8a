// Writes OpenEXR files with OpenEXR alone, without loading OpenImageIO.
#pragma once

#include <string>

#include "image/image.h"

namespace strad {

// Half floats, ZIP compression. Returns an error message, empty for success.
std::string write_exr(const std::string& path, const Image& image);

}  // namespace strad
