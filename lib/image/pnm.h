// Pictures as bytes, for pipes and files: binary PPM (8 or 16 bits) and PFM (linear floats).
#pragma once

#include <string>
#include <string_view>

#include "image/encoding.h"
#include "image/image.h"

namespace strad {

std::string encode_ppm(const Image& image, const Encoding& encoding = {});
std::string encode_pfm(const Image& image);

// Reads P6 of 8 or 16 bits (on the sRGB curve), PF and Pf. Throws BadInput beginning with `name`, the file's
// name. Bytes after the picture are refused: a file holds one.
Image decode_pnm(std::string_view bytes, const std::string& name);

// Whether the bytes begin as a PPM or PFM file does.
bool is_pnm(std::string_view bytes);

}  // namespace strad
