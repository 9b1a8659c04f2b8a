// A picture of several layers, such as light of different origin, distances and normals.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "image/image.h"

namespace strad {

struct Layer {
  std::string name;            // "": the picture that programs without a notion of layers show
  std::string channels;        // a letter each, "RGB" or "XYZ"
  bool exact = false;          // 32-bit floats whatever the depth: numbers that are no light
  std::vector<float> samples;  // pixel after pixel, rows from the top, all channels of a pixel together
};

struct LayeredImage {
  uint32_t width = 0, height = 0;
  std::vector<Layer> layers;
  std::vector<std::pair<std::string, std::string>> texts;  // names and values that go with them
};

// "name.C", or "C" for the layer without a name: the convention of OpenEXR (Technical Introduction,
// "Layers").
inline std::string channel_name(const Layer& layer, size_t channel) {
  return (layer.name.empty() ? "" : layer.name + ".") + layer.channels[channel];
}

Layer layer_of(const Image& image, const std::string& name);

}  // namespace strad
