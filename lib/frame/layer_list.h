// The layers that pictures may have, in the words of a command line.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace strad {

enum class LayerKind : uint8_t {
  kCombined,
  kDirect,
  kIndirect,
  kEmission,
  kSpecular,
  kAlbedo,
  kNormal,
  kPosition,
  kDepth,
  kMotion,
  kObject,
  kMaterial
};

// "combined,depth,motion" or "all", which is all but specular: that is for scenes which have any. Throws
// BadInput beginning with `option` for other words and for none.
std::vector<LayerKind> parse_layers(const std::string& option, const std::string& text);

const char* word_of(LayerKind kind);

// May its numbers be those of a picture that is no EXR file: light, colours and directions?
bool is_picture(LayerKind kind);

// Is it found by camera rays alone, without any light?
inline bool is_geometry(LayerKind kind) { return kind >= LayerKind::kAlbedo; }

}  // namespace strad
