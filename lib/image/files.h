// Pictures in files. PPM and PFM are read and written here; EXR and PNG are written with their own libraries.
// All other formats go through OpenImageIO. It is in a module that is loaded at the first such file, because
// loading takes 0.3 s, four times as long as a small frame.
#pragma once

#include <string>

#include "image/image.h"

namespace strad {

// Linear RGB. Integers are taken to be on the sRGB curve, floats to be linear. Grey fills all channels, alpha
// is dropped. "-" is standard input, for PPM and PFM. Throws IoError or BadInput beginning with the
// path; a pixel that is not finite is bad, and so is what is no plain file, for it may never end.
Image load_image(const std::string& path);

// The same as 8-bit sRGB. The bytes of an 8-bit file are kept as they are.
SrgbImage load_srgb_image(const std::string& path);

// The extension names the format. EXR: half floats, those above the largest half clamped to it, equal pixels
// giving equal bytes. Integer formats are on the sRGB curve: 16 bits in TIFF, 8 elsewhere. The file is
// complete or absent (stream/output_file.h).
void save_image(const std::string& path, const Image& image);

// Throws BadInput unless `save_image` knows the format of `path`. For tools that compute for long before they
// save.
void require_image_format(const std::string& path);

}  // namespace strad
