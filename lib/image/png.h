// Makes PNG files with libpng alone, without loading OpenImageIO.
#pragma once

#include <string>

#include "image/encoding.h"
#include "image/image.h"
#include "image/picture_facts.h"

namespace strad {

// The bytes of the file: 8 or 16 bits. Chunks say which curve and primaries the numbers have, and texts the
// facts. Throws IoError. REQUIRES: a depth that PNG has.
std::string encode_png(const Image& image, const Encoding& encoding, const PictureFacts& facts);

}  // namespace strad
