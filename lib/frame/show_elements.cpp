#include "frame/show_elements.h"

#include <vector>

#include "base/parallel.h"
#include "base/rng.h"

namespace strad {
namespace {

constexpr float kBorder = 0.2f;  // of the mean colour around it
constexpr uint64_t kNothing = 0, kNoMesh = 1;

// By element: where it lies, as a number: of its polygon, side, and the children down to it.
std::vector<uint64_t> keys_of(const Mesh& mesh) {
  std::vector<uint64_t> keys(mesh.elements.size(), kNothing);
  for (const Face& face : mesh.faces) keys[face.element] = hash_of(face.polygon, face.side);
  for (size_t e = 0; e < mesh.elements.size(); ++e) {  // parents come before their children
    const uint32_t first = mesh.elements[e].first_child;
    if (first == kNone) continue;
    for (uint32_t c = 0; c < 4; ++c) keys[first + c] = hash_of(keys[e], uint64_t{c} + 1);
  }
  return keys;
}

Rgb colour_of(uint64_t key) {
  if (key == kNothing) return {};
  if (key == kNoMesh) return {kNoMeshGrey, kNoMeshGrey, kNoMeshGrey};
  Rgb colour;
  for (int c = 0; c < 3; ++c)
    colour[c] = static_cast<float>(0.1 + 0.8 * unit_from(hash_of(key, static_cast<uint64_t>(c))));
  return colour;
}

uint64_t key_at(const ShowView& view, const Mesh& mesh, const std::vector<uint64_t>& keys, double x,
                double y) {
  const Sight sight = view.look(x, y);
  if (sight.point.polygon == kNone) return kNothing;
  const uint32_t face = face_seen(mesh, sight);
  return face == kNone ? kNoMesh : keys[locate(mesh, face, sight.at).element];
}

}  // namespace

Image elements_picture(const ShowView& view, const Mesh& mesh) {
  const std::vector<uint64_t> keys = keys_of(mesh);
  const size_t columns = size_t{view.width} + 1;
  std::vector<uint64_t> seen(columns * (size_t{view.height} + 1));  // at the corners of pixels
  parallel_for(size_t{view.height} + 1, 1, [&](size_t begin, size_t end) {
    for (size_t y = begin; y < end; ++y)
      for (size_t x = 0; x < columns; ++x)
        seen[y * columns + x] = key_at(view, mesh, keys, static_cast<double>(x), static_cast<double>(y));
  });
  Image image(view.width, view.height);
  for (uint32_t y = 0; y < view.height; ++y)
    for (uint32_t x = 0; x < view.width; ++x) {
      const size_t at = y * columns + x;
      const uint64_t corners[4] = {seen[at], seen[at + 1], seen[at + columns], seen[at + columns + 1]};
      Rgb mean;
      bool alike = true;
      for (const uint64_t key : corners) {
        mean += 0.25f * colour_of(key);
        alike &= key == corners[0];
      }
      image.at(x, y) = alike ? colour_of(corners[0]) : kBorder * mean;
    }
  return image;
}

}  // namespace strad
