// Makes OpenEXR files with OpenEXR alone, without loading OpenImageIO.
#pragma once

#include <string>

#include "image/encoding.h"
#include "image/layers.h"
#include "image/picture_facts.h"

namespace strad {

// The bytes of the file: one part with the channels of all layers, ZIP compression. Half floats are those
// nearest to the samples, at most the largest half. Attributes tell the facts, under the names that OpenEXR
// has for them. Throws IoError. REQUIRES: a depth that EXR has.
std::string encode_exr(const LayeredImage& image, Depth depth, const PictureFacts& facts);

}  // namespace strad
