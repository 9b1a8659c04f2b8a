#include "export/ply/ply.h"

#include <bit>
#include <cmath>
#include <vector>

#include "export/mesh.h"
#include "image/srgb.h"
#include "scene/texture.h"
#include "scene/trajectory.h"

namespace strad {
namespace {

constexpr size_t kVertexBytes = 39;    // six or nine floats, three bytes
constexpr size_t kTriangleBytes = 13;  // a count and three indices

void put(uint32_t word, std::string* out) {
  for (int shift = 0; shift < 32; shift += 8) *out += static_cast<char>((word >> shift) & 255);
}
void put(float number, std::string* out) { put(std::bit_cast<uint32_t>(number), out); }
void put(Vec3 v, std::string* out) {
  put(static_cast<float>(v.x), out);
  put(static_cast<float>(v.y), out);
  put(static_cast<float>(v.z), out);
}
void put(Rgb c, std::string* out) {
  put(c.r, out);
  put(c.g, out);
  put(c.b, out);
}

std::string header(size_t vertices, size_t triangles, bool normals) {
  return "ply\nformat binary_little_endian 1.0\ncomment strad: world, m; radiance in W / (sr m^2)\nelement "
         "vertex " +
         std::to_string(vertices) + "\nproperty float x\nproperty float y\nproperty float z\n" +
         (normals ? "property float nx\nproperty float ny\nproperty float nz\n" : "") +
         "property uchar red\nproperty uchar green\nproperty uchar blue\n"
         "property float radiance_r\nproperty float radiance_g\nproperty float radiance_b\nelement face " +
         std::to_string(triangles) + "\nproperty list uchar uint vertex_indices\nend_header\n";
}

}  // namespace

struct PlyExport::State {
  const Scene& scene;
  const Solution& solution;
  std::vector<Rgb> textured_reflectance;        // per material
  std::vector<std::vector<ExportBody>> meshes;  // per slab

  State(const Scene& s, const Solution& light)
      : scene(s), solution(light), textured_reflectance(textured_reflectances(s)) {
    for (const Slab& slab : solution.slabs) meshes.push_back(export_mesh(scene, slab, ExportLight::kAll));
  }

  Rgb radiance(const ExportCorner& corner, const VertexLight& light, const std::vector<float>& glow) const {
    const Rgb irradiance =
        corner_irradiance(corner, light.direct) + corner_irradiance(corner, light.indirect);
    const Material& material = scene.materials[corner.material];
    const Rgb reflectance = corner.textured ? textured_reflectance[corner.material] : material.reflectance;
    const Rgb reflected = (1 / static_cast<float>(kPi)) * reflectance * irradiance;
    if (!corner.emits) return reflected;
    return reflected + glow[corner.material] * material.emission;
  }
};

PlyExport::PlyExport(const Scene& scene, const Solution& solution)
    : state_(std::make_unique<const State>(scene, solution)) {}

PlyExport::~PlyExport() = default;

std::string PlyExport::frame(double time, double exposure) const {
  const State& s = *state_;
  const uint32_t slab = slab_at(s.solution, time);
  const VertexLight light = light_at(s.solution.slabs[slab], time);
  const std::vector<float> glow = glow_at(s.scene, time);
  const std::vector<Pose> world_from_body = poses_at(s.scene, time);
  const auto scale = static_cast<float>(std::exp2(exposure));

  size_t vertices = 0, triangles = 0;
  for (const ExportBody& body : s.meshes[slab]) {
    vertices += body.corners.size();
    triangles += body.triangles.size();
  }
  const bool normals = !s.scene.normals.empty();
  std::string out = header(vertices, triangles, normals);
  out.reserve(out.size() + vertices * kVertexBytes + triangles * kTriangleBytes);
  for (const ExportBody& body : s.meshes[slab]) {
    for (const ExportCorner& corner : body.corners) {
      const Rgb radiance = s.radiance(corner, light, glow);
      put(world_from_body[body.body] * corner.position, &out);
      if (normals) put(rotate(world_from_body[body.body], corner.normal), &out);
      for (int channel = 0; channel < 3; ++channel) {
        out += static_cast<char>(srgb_byte(scale * radiance[channel]));
      }
      put(radiance, &out);
    }
  }
  uint32_t first = 0;
  for (const ExportBody& body : s.meshes[slab]) {
    for (const auto& triangle : body.triangles) {
      out += '\3';
      for (const uint32_t corner : triangle) put(first + corner, &out);
    }
    first += static_cast<uint32_t>(body.corners.size());
  }
  return out;
}

}  // namespace strad
