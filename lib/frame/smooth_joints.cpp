#include "frame/smooth_joints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace strad {

// Finds what meets by keys: where in the scene (the first vertex at the place), with which normal, of which
// body and side.
class SmoothJoints::Builder {
 public:
  Builder(const Scene& scene, const Mesh& mesh, const Reconstruction& reconstruction, SmoothJoints* joints)
      : scene_(scene), mesh_(mesh), reconstruction_(reconstruction), joints_(*joints) {}

  void run() {
    find_positions();
    for (uint32_t f = 0; f < mesh_.faces.size(); ++f) {
      const Face& face = mesh_.faces[f];
      if (scene_.polygons[face.polygon].is_smooth()) add(f, face);
    }
    for (auto& [key, members] : points_) close_group(members);
    for (auto& [key, edge] : edges_) close_edge(&edge);
    joints_.groups_.push_back(joints_.members_.size());
  }

 private:
  using Corner = std::tuple<uint32_t, uint32_t, uint32_t, uint32_t>;  // position, normal, body, side
  struct Middle {
    Member member;
    uint32_t before, after;
  };
  struct Edge {
    int faces = 0;
    std::map<std::pair<int, uint32_t>, std::vector<Middle>> middles;  // by level and place from the first end
  };

  void find_positions();
  Corner corner_key(const Face& face, int corner) const;
  double angle_at(const Polygon& polygon, int corner) const;
  void add(uint32_t f, const Face& face);
  void walk(Edge* edge, uint32_t a, uint32_t b, bool turned, int level, uint32_t place);
  void close_group(const std::vector<Member>& members);
  void close_edge(Edge* edge);

  const Scene& scene_;
  const Mesh& mesh_;
  const Reconstruction& reconstruction_;
  SmoothJoints& joints_;
  std::vector<uint32_t> position_of_;  // by vertex: the first at the same place
  std::map<Corner, std::vector<Member>> points_;
  std::map<std::pair<Corner, Corner>, Edge> edges_;
};

void SmoothJoints::Builder::find_positions() {
  std::vector<uint32_t> order(scene_.vertices.size());
  for (uint32_t v = 0; v < order.size(); ++v) order[v] = v;
  const auto key = [&](uint32_t v) {
    const Vec3 p = scene_.vertices[v];
    return std::tuple{p.x, p.y, p.z, v};
  };
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return key(a) < key(b); });
  position_of_.resize(order.size());
  for (size_t i = 0; i < order.size(); ++i) {
    const bool again = i > 0 && scene_.vertices[order[i]] == scene_.vertices[order[i - 1]];
    position_of_[order[i]] = again ? position_of_[order[i - 1]] : order[i];
  }
}

SmoothJoints::Builder::Corner SmoothJoints::Builder::corner_key(const Face& face, int corner) const {
  const Polygon& polygon = scene_.polygons[face.polygon];
  return {position_of_[polygon.corners[corner]], polygon.normals[corner], body_of(scene_, polygon),
          face.side};
}

double SmoothJoints::Builder::angle_at(const Polygon& polygon, int corner) const {
  const int count = polygon.corner_count();
  const auto at = [&](int k) { return scene_.vertices[polygon.corners[(k + count) % count]]; };
  const Vec3 a = at(corner - 1) - at(corner), b = at(corner + 1) - at(corner);
  return std::acos(std::clamp(dot(a, b) / (length(a) * length(b)), -1.0, 1.0));
}

void SmoothJoints::Builder::add(uint32_t f, const Face& face) {
  const Polygon& polygon = scene_.polygons[face.polygon];
  const Element& root = mesh_.elements[face.element];
  const bool single = is_uniform(root);
  if (single) {
    joints_.slots_.resize(mesh_.faces.size(), kNone);
    joints_.slots_[f] = joints_.slot_count_++;
  }
  const int count = polygon.corner_count();
  for (int c = 0; c < count; ++c) {
    const uint32_t vertex = root.vertices[c];
    const uint32_t target = single ? 4 * joints_.slots_[f] + static_cast<uint32_t>(c) : vertex;
    points_[corner_key(face, c)].push_back(
        {target, vertex, static_cast<float>(std::max(angle_at(polygon, c), 1e-6)), single});
    const Corner a = corner_key(face, c), b = corner_key(face, (c + 1) % count);
    Edge& edge = edges_[{std::min(a, b), std::max(a, b)}];
    ++edge.faces;
    if (!single) walk(&edge, vertex, root.vertices[(c + 1) % count], b < a, 0, 0);
  }
}

// The vertices between a and b, halves within halves.
void SmoothJoints::Builder::walk(Edge* edge, uint32_t a, uint32_t b, bool turned, int level, uint32_t place) {
  const uint32_t middle = reconstruction_.middle_of(a, b);
  if (middle == kNone) return;
  const uint32_t last = (1u << level) - 1;
  edge->middles[{level, turned ? last - place : place}].push_back({{middle, middle, 1, false}, a, b});
  walk(edge, a, middle, turned, level + 1, 2 * place);
  walk(edge, middle, b, turned, level + 1, 2 * place + 1);
}

void SmoothJoints::Builder::close_group(const std::vector<Member>& members) {
  joints_.groups_.push_back(joints_.members_.size());
  joints_.members_.insert(joints_.members_.end(), members.begin(), members.end());
}

void SmoothJoints::Builder::close_edge(Edge* edge) {
  if (edge->faces < 2) return;
  for (const auto& [key, middles] : edge->middles) {
    if (static_cast<int>(middles.size()) == edge->faces) {
      std::vector<Member> members;
      for (const Middle& middle : middles) members.push_back(middle.member);
      close_group(members);
    } else {
      for (const Middle& middle : middles)
        joints_.hanging_.push_back({middle.member.target, middle.before, middle.after});
    }
  }
}

SmoothJoints::SmoothJoints(const Scene& scene, const Mesh& mesh, const Reconstruction& reconstruction)
    : scene_(scene), mesh_(mesh) {
  if (!scene.normals.empty()) Builder(scene, mesh, reconstruction, this).run();
}

std::vector<Rgb> SmoothJoints::join(std::vector<Rgb>* vertex_values) const {
  std::vector<Rgb> corner_values(size_t{4} * slot_count_);
  std::vector<Rgb> means;
  for (size_t g = 0; g + 1 < groups_.size(); ++g) {
    Rgb sum;
    float weights = 0;
    for (size_t m = groups_[g]; m < groups_[g + 1]; ++m) {
      sum += members_[m].weight * (*vertex_values)[members_[m].source];
      weights += members_[m].weight;
    }
    means.push_back((1 / weights) * sum);
  }
  for (size_t g = 0; g + 1 < groups_.size(); ++g)
    for (size_t m = groups_[g]; m < groups_[g + 1]; ++m)
      (members_[m].is_corner ? corner_values[members_[m].target] : (*vertex_values)[members_[m].target]) =
          means[g];
  for (const Hanging& hanging : hanging_)
    (*vertex_values)[hanging.vertex] =
        0.5f * ((*vertex_values)[hanging.before] + (*vertex_values)[hanging.after]);
  return corner_values;
}

Rgb SmoothJoints::between(uint32_t face, const Rgb* corners, Vec2 at) const {
  const Polygon& polygon = scene_.polygons[mesh_.faces[face].polygon];
  const CornerWeights weights = corner_weights(polygon, at);
  Rgb sum;
  for (int c = 0; c < polygon.corner_count(); ++c) sum += static_cast<float>(weights.of[c]) * corners[c];
  return sum;
}

}  // namespace strad
