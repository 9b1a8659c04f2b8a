#include "frame/frame_light.h"

namespace strad {

FrameLight::FrameLight(const Slab& slab, const Reconstruction& reconstruction, const SmoothJoints& joints,
                       double begin, double end, const FrameLightOptions& options)
    : mesh_(slab.mesh), reconstruction_(reconstruction), flat_(options.flat), joints_(joints) {
  const LightParts parts = options.with_direct ? LightParts::kAll : LightParts::kIndirect;
  VertexLight light = end > begin ? light_over(slab, begin, end, !options.flat, parts)
                                  : light_at(slab, begin, !options.flat, parts);
  vertex_irradiance_ = std::move(light.indirect);
  if (options.with_direct)
    for (size_t v = 0; v < vertex_irradiance_.size(); ++v) vertex_irradiance_[v] += light.direct[v];
  if (!flat_) corner_irradiance_ = joints_.join(&vertex_irradiance_);
}

Rgb FrameLight::irradiance(uint32_t polygon, bool front, Vec2 at, uint32_t* leaf) const {
  const uint32_t face = mesh_.face_of_side[2 * size_t{polygon} + (front ? 0 : 1)];
  if (face == kNone) return {};
  if (flat_) return reconstruction_.flat(vertex_irradiance_, face, at, leaf);
  if (const Rgb* corners = joints_.corners_of(face, corner_irradiance_))
    return joints_.between(face, corners, at);
  return reconstruction_.smooth(vertex_irradiance_, face, at);
}

}  // namespace strad
