#include "image/png.h"

#include <png.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include "base/error.h"
#include "image/srgb.h"

namespace strad {

std::string encode_png(const Image& image) {
  std::vector<uint8_t> bytes;
  bytes.reserve(3 * image.pixels.size());
  for (const Rgb& pixel : image.pixels)
    for (int c = 0; c < 3; ++c) bytes.push_back(srgb_byte(pixel[c]));
  png_image picture{};
  picture.version = PNG_IMAGE_VERSION;
  picture.width = image.width;
  picture.height = image.height;
  picture.format = PNG_FORMAT_RGB;
  char* encoded = nullptr;
  size_t size = 0;
  std::FILE* const memory = ::open_memstream(&encoded, &size);
  if (!memory) throw std::bad_alloc();
  const bool done = png_image_write_to_stdio(&picture, memory, 0, bytes.data(), 0, nullptr) != 0;
  const bool closed = std::fclose(memory) == 0;
  const std::unique_ptr<char, void (*)(void*)> owner(encoded, std::free);
  if (!done) throw IoError(picture.message);
  if (!closed) throw std::bad_alloc();
  return {encoded, size};
}

}  // namespace strad
