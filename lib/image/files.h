// Pictures in files. PPM and PFM are read and written here, EXR and PNG written with their own libraries; all
// else goes through OpenImageIO, which lives in a module that is loaded when the first such file is touched
// (it costs 0.3 s, four times a small frame).
#pragma once

#include <string>

#include "image/image.h"

namespace strad {

// Linear RGB: whole numbers are taken to be on the sRGB curve, floats to be linear; grey fills all channels
// and alpha is dropped. "-" is standard input, for PPM and PFM. Throws IoError or BadInput beginning with the
// path.
Image load_image(const std::string& path);

// The same as 8-bit sRGB, byte for byte what an 8-bit file holds.
SrgbImage load_srgb_image(const std::string& path);

// The extension names the format. EXR: half floats, those above the largest half clamped to it, equal pixels
// giving equal bytes. Whole numbers are on the sRGB curve: 16 bits in TIFF, 8 elsewhere. The file is written
// beside and renamed, so it is whole or absent.
void save_image(const std::string& path, const Image& image);

// Throws BadInput unless `save_image` knows the format of `path`; for tools that work long before they save.
void require_image_format(const std::string& path);

}  // namespace strad
