#include "scene/normals_io.h"

#include <algorithm>

#include "base/error.h"
#include "scene/octahedral.h"

namespace strad {
namespace {

// Numbers of corners: frozen.
constexpr uint32_t kFlat = 0;   // the whole polygon
constexpr uint32_t kSame = 1;   // the normal that the vertex had last, or a new one if it had none yet
constexpr uint32_t kFirst = 2;  // and on: that normal

// Predicts the normal of a corner: that which its vertex had last, else the smallest that was not named yet.
class NormalPredictor {
 public:
  explicit NormalPredictor(size_t vertex_count) : last_(vertex_count, kNone) {}
  uint32_t predicted(uint32_t vertex) const { return last_[vertex] != kNone ? last_[vertex] : next_; }
  void see(uint32_t vertex, uint32_t normal) {
    last_[vertex] = normal;
    next_ = std::max(next_, normal + 1);
  }

 private:
  std::vector<uint32_t> last_;
  uint32_t next_ = 0;
};

}  // namespace

void put_normals(Bytes* to, const Scene& scene) {
  put_varint(to, scene.normals.size());
  std::vector<uint64_t> codes;
  for (const Vec3& normal : scene.normals) codes.push_back(octahedral_code(normal));
  put_planes(to, codes, 4);
  std::vector<uint32_t> corners;
  NormalPredictor predictor(scene.vertices.size());
  for (const Polygon& polygon : scene.polygons) {
    if (!polygon.is_smooth()) corners.push_back(kFlat);
    for (int c = 0; polygon.is_smooth() && c < polygon.corner_count(); ++c) {
      const uint32_t vertex = polygon.corners[c], normal = polygon.normals[c];
      corners.push_back(normal == predictor.predicted(vertex) ? kSame : kFirst + normal);
      predictor.see(vertex, normal);
    }
  }
  put_varint(to, corners.size());
  for (const uint32_t corner : corners) put_varint(to, corner);
}

StoredNormals get_normals(ByteReader* from) {
  StoredNormals stored;
  const size_t count = from->count(4, "normals");
  for (const uint64_t code : get_planes(from, count, 4))
    stored.normals.push_back(octahedral_vector(static_cast<uint32_t>(code)));
  stored.corners.resize(from->count(1, "corners"));
  for (uint32_t& corner : stored.corners) corner = from->number(kNone - 1, "a normal of a corner");
  return stored;
}

void apply_normals(StoredNormals stored, const std::string& place, Scene* scene) {
  scene->normals = std::move(stored.normals);
  NormalPredictor predictor(scene->vertices.size());
  size_t at = 0;
  const auto fail = [&](const std::string& what) { throw BadInput(place + ": chunk norm: " + what); };
  for (Polygon& polygon : scene->polygons) {
    if (at == stored.corners.size()) fail("found too few corners for the polygons");
    if (stored.corners[at] == kFlat) {
      ++at;
      continue;
    }
    for (int c = 0; c < polygon.corner_count(); ++c, ++at) {
      const uint32_t vertex = polygon.corners[c];
      if (at == stored.corners.size() || stored.corners[at] == kFlat)
        fail("found a normal at some corners of a polygon only");
      if (vertex >= scene->vertices.size()) fail("found a polygon with a vertex that is not there");
      const uint32_t corner = stored.corners[at];
      const uint32_t normal = corner == kSame ? predictor.predicted(vertex) : corner - kFirst;
      if (normal >= scene->normals.size()) fail("found a corner with a normal that is not there");
      polygon.normals[c] = normal;
      predictor.see(vertex, normal);
    }
  }
  if (at != stored.corners.size()) fail("found more corners than the polygons have");
}

}  // namespace strad
