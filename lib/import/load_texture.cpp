#include "import/load_texture.h"

#include "base/text.h"
#include "image/files.h"
#include "image/srgb.h"

namespace strad {
namespace {

// load_image takes the numbers of 8-bit files to be on the sRGB curve; here they are light.
SrgbImage srgb_from_linear_file(const std::string& path) {
  const Image loaded = load_image(path);
  SrgbImage picture;
  picture.width = loaded.width;
  picture.height = loaded.height;
  for (const Rgb pixel : loaded.pixels)
    for (int c = 0; c < 3; ++c) picture.bytes.push_back(srgb_byte(srgb_from_linear(pixel[c])));
  return picture;
}

}  // namespace

Texture load_texture(const TextureSource& source) {
  try {
    SrgbImage picture = source.linear ? srgb_from_linear_file(source.path) : load_srgb_image(source.path);
    return {source.name, picture.width, picture.height, std::move(picture.bytes)};
  } catch (const std::exception& error) {
    fail_at(source.file, source.line, error.what());
  }
}

}  // namespace strad
