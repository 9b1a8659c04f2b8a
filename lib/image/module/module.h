// What the module strad-image-files.so offers to lib/image/files.cpp. Functions return an error message,
// empty for success, so that no exception crosses from one shared library to another.
#pragma once

#include <string>

#include "image/image.h"

namespace strad {

struct ImageModule {
  std::string (*read)(const std::string& path, Image* image);
  std::string (*read_srgb)(const std::string& path, SrgbImage* image);
  bool (*knows)(const std::string& format);  // an extension without its dot
  // `bytes` are those of the file. On the sRGB curve. `eight_bits`: where the format also has more.
  std::string (*encode)(const std::string& format, bool eight_bits, const Image& image, std::string* bytes);
};

// The one symbol that is looked up in the module; `ImageModuleEntry` is its type.
constexpr const char* kImageModuleSymbol = "strad_image_module";
using ImageModuleEntry = const ImageModule* (*)();

}  // namespace strad
