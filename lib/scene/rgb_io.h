// Colours to bytes and back.
#pragma once

#include "base/rgb.h"
#include "stream/bytes.h"

namespace strad {

// f32 R, G, B.
inline void put_rgb(Bytes* to, Rgb rgb) {
  for (int c = 0; c < 3; ++c) put_f32(to, rgb[c]);
}

inline Rgb get_rgb(ByteReader* from) {
  Rgb rgb;
  for (int c = 0; c < 3; ++c) rgb[c] = from->f32();
  return rgb;
}

}  // namespace strad
