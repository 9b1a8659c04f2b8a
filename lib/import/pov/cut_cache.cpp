#include "import/pov/cut_cache.h"

#include <bit>

#include "base/rng.h"

namespace strad {
namespace {

class Hasher {
 public:
  void add(uint64_t value) {
    key_[0] = hash_of(key_[0], value);
    key_[1] = hash_of(value, key_[1]);
  }
  void add(double value) { add(std::bit_cast<uint64_t>(value)); }
  void add(Vec3 p) { add(p.x), add(p.y), add(p.z); }
  void add(const PovSolid& solid) {
    add(uint64_t{solid.kind} << 1 | uint64_t{solid.inverse});
    add(uint64_t{solid.parts.size()});
    for (const PovSolid& part : solid.parts) add(part);
    add(solid.plane.normal), add(solid.plane.distance);
    if (!solid.hull) return;
    for (const Vec3 row : solid.placed.rows) add(row);
    add(uint64_t{solid.hull->points.size()}), add(uint64_t{solid.hull->triangles.size()});
    for (const Vec3 p : solid.hull->points) add(p);
    for (const auto& corners : solid.hull->triangles)
      for (const uint32_t corner : corners) add(uint64_t{corner});
  }
  void add(const PovObject& object) {
    add(uint64_t{object.points.size()}), add(uint64_t{object.uvs.size()}),
        add(uint64_t{object.facets.size()});
    add(uint64_t{object.endless});
    for (const Vec3 p : object.points) add(p);
    for (const Vec2 p : object.uvs) add(p.x), add(p.y);
    for (const PovFacet& facet : object.facets) {
      add(uint64_t{facet.corners.size()}), add(uint64_t{facet.uvs.size()}),
          add(uint64_t{facet.normals.size()});
      for (const uint32_t corner : facet.corners) add(uint64_t{corner});
      for (const uint32_t uv : facet.uvs) add(uint64_t{uv});
      for (const Vec3 normal : facet.normals) add(normal);
      add(uint64_t{facet.part});
    }
    add(object.solid);
  }
  PovCutCache::Key key() const { return key_; }

 private:
  PovCutCache::Key key_{1, 2};
};

}  // namespace

PovCutCache::Key PovCutCache::key_of(std::span<const PovObject> objects, std::span<const PovSolid> solids) {
  Hasher hasher;
  hasher.add(uint64_t{objects.size()});
  for (const PovObject& object : objects) hasher.add(object);
  for (const PovSolid& solid : solids) hasher.add(solid);
  return hasher.key();
}

std::shared_ptr<const PovCut> PovCutCache::find(const Key& key) {
  if (const auto known = now_.find(key); known != now_.end()) return known->second;
  const auto known = before_.find(key);
  if (known == before_.end()) return nullptr;
  return now_[key] = known->second;
}

void PovCutCache::next_frame() {
  before_ = std::move(now_);
  now_.clear();
}

}  // namespace strad
