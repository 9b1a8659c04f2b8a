#include "image/png.h"

#include <png.h>

#include <vector>

#include "image/srgb.h"

namespace strad {

std::string write_png(const std::string& path, const Image& image) {
  std::vector<uint8_t> bytes;
  bytes.reserve(3 * image.pixels.size());
  for (const Rgb& pixel : image.pixels)
    for (int c = 0; c < 3; ++c) bytes.push_back(srgb_byte(pixel[c]));
  png_image picture{};
  picture.version = PNG_IMAGE_VERSION;
  picture.width = image.width;
  picture.height = image.height;
  picture.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&picture, path.c_str(), 0, bytes.data(), 0, nullptr)) return "";
  return picture.message;
}

}  // namespace strad
