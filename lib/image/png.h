// Writes PNG files with libpng alone, without loading OpenImageIO.
#pragma once

#include <string>

#include "image/encoding.h"
#include "image/image.h"
#include "image/picture_facts.h"

namespace strad {

// 8 or 16 bits. Chunks say which curve and primaries the numbers have, and texts the facts. Returns an error
// message, empty for success. REQUIRES: a depth that PNG has.
std::string write_png(const std::string& path, const Image& image, const Encoding& encoding,
                      const PictureFacts& facts);

}  // namespace strad
