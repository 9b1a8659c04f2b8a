// Pictures in files. PPM and PFM are read and written here; EXR and PNG are written with their own libraries.
// All other formats go through OpenImageIO. It is in a module that is loaded at the first such file, because
// loading takes 0.3 s, four times as long as a small frame.
#pragma once

#include <string>

#include "image/encoding.h"
#include "image/image.h"
#include "image/layers.h"
#include "image/picture_facts.h"

namespace strad {

// Linear RGB. Integers are taken to be on the sRGB curve, floats to be linear. Grey fills all channels, alpha
// is dropped. "-" is standard input, for PPM and PFM. Throws IoError or BadInput beginning with the
// path; a pixel that is not finite is bad, and so is what is no plain file, for it may never end.
Image load_image(const std::string& path);

// The same as 8-bit sRGB, with alpha. The bytes of an 8-bit file are kept as they are.
SrgbImage load_srgb_image(const std::string& path);

// The extension names the format. EXR: half floats unless floats are asked for, those above the largest half
// clamped to it. Equal pixels and facts give equal bytes; only EXR and PNG hold facts. The file is complete
// or absent (stream/output_file.h). REQUIRES: a depth that the format has.
void save_image(const std::string& path, const Image& image, const Encoding& encoding = {},
                const PictureFacts& facts = {});

// The same for an EXR file of several layers.
void save_layers(const std::string& path, const LayeredImage& image, Depth depth, const PictureFacts& facts);

// Throws BadInput unless `save_image` knows the format of `path`. For tools that compute for long before they
// save.
void require_image_format(const std::string& path);

// The extension of `path` in lower case, without its dot: "exr".
std::string format_of(const std::string& path);

}  // namespace strad
