#include "import/coincident_lamps.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "base/text.h"

namespace strad {
namespace {

using Corner = std::array<double, 3>;

// The corners in their order, which tells the side that emits, from the least one on.
std::vector<Corner> outline_of(const Scene& scene, const Polygon& polygon) {
  std::vector<Corner> outline;
  for (int c = 0; c < polygon.corner_count(); ++c) {
    const Vec3& at = scene.vertices[polygon.corners[c]];
    outline.push_back({at.x, at.y, at.z});
  }
  std::rotate(outline.begin(), std::min_element(outline.begin(), outline.end()), outline.end());
  return outline;
}

}  // namespace

void tell_coincident_lamps(const Scene& scene, const std::string& name, ImportReport* report) {
  std::set<std::vector<Corner>> seen;
  size_t count = 0;
  uint32_t first = kNone;
  for (const Polygon& polygon : scene.polygons) {
    if (is_black(scene.materials[polygon.material].emission)) continue;
    if (seen.insert(outline_of(scene, polygon)).second) continue;
    if (++count == 1) first = polygon.object;
  }
  if (count == 0) return;
  report->add(std::to_string(count) + " emitting polygons lie exactly on others, such as one of " +
                  in_quotes(scene.objects[first].name) + ": their light adds up",
              name, 0);
}

}  // namespace strad
