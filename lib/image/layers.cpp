#include "image/layers.h"

namespace strad {

Layer layer_of(const Image& image, const std::string& name) {
  Layer layer{name, "RGB", false, {}};
  layer.samples.reserve(3 * image.pixels.size());
  for (const Rgb& pixel : image.pixels)
    for (int c = 0; c < 3; ++c) layer.samples.push_back(pixel[c]);
  return layer;
}

}  // namespace strad
