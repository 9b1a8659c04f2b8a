#include "import/load_texture.h"

#include "base/text.h"
#include "image/files.h"
#include "image/srgb.h"

namespace strad {
namespace {

// For a file of linear numbers. load_image takes 8-bit numbers to be on the sRGB curve: srgb_from_linear
// undoes that, and srgb_byte then encodes them as the light that they are.
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
    Texture texture{source.name, picture.width, picture.height, std::move(picture.bytes)};
    if (!picture.alpha.empty()) texture.opacity = {picture.width, picture.height, std::move(picture.alpha)};
    return texture;
  } catch (const std::exception& error) {
    fail_at(source.file, source.line, error.what());
  }
}

Opacity load_opacity(const TextureSource& source) {
  const Texture texture = load_texture(source);
  if (!texture.opacity.values.empty()) return texture.opacity;
  Opacity opacity{texture.width, texture.height, {}};
  for (size_t i = 0; i < texture.srgb.size(); i += 3) opacity.values.push_back(texture.srgb[i]);
  return opacity;
}

}  // namespace strad
