#include "import/smooth_normals.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/octahedral.h"
#include "scene/polygon_geometry.h"

namespace strad {
namespace {

const double kCosFlat = std::cos(0.1 * kPi / 180);

struct CornerAt {
  uint32_t polygon;
  int corner;
};

// Corners of all polygons, those at one position together. begins[i]: where the i-th position begins.
struct CornersByPosition {
  std::vector<CornerAt> corners;
  std::vector<size_t> begins;
};

CornersByPosition corners_by_position(const Scene& scene) {
  CornersByPosition by;
  const auto at = [&](const CornerAt& c) {
    return scene.vertices[scene.polygons[c.polygon].corners[c.corner]];
  };
  for (uint32_t p = 0; p < scene.polygons.size(); ++p)
    for (int c = 0; c < scene.polygons[p].corner_count(); ++c) by.corners.push_back({p, c});
  std::stable_sort(by.corners.begin(), by.corners.end(), [&](const CornerAt& a, const CornerAt& b) {
    const Vec3 u = at(a), v = at(b);
    return u.x != v.x ? u.x < v.x : u.y != v.y ? u.y < v.y : u.z < v.z;
  });
  for (size_t i = 0; i < by.corners.size(); ++i)
    if (i == 0 || !(at(by.corners[i]) == at(by.corners[i - 1]))) by.begins.push_back(i);
  by.begins.push_back(by.corners.size());
  return by;
}

double angle_at(const Scene& scene, const CornerAt& at) {
  const Polygon& polygon = scene.polygons[at.polygon];
  const int count = polygon.corner_count();
  const auto corner = [&](int k) { return scene.vertices[polygon.corners[(k + count) % count]]; };
  const Vec3 a = corner(at.corner - 1) - corner(at.corner), b = corner(at.corner + 1) - corner(at.corner);
  return std::acos(std::clamp(dot(a, b) / (length(a) * length(b)), -1.0, 1.0));
}

}  // namespace

NormalsGiven SmoothNormals::set(Polygon* polygon, const Vec3* given) {
  const Vec3 own = polygon_normal(*scene_, *polygon);
  const int count = polygon->corner_count();
  int before = 0, flat = 0;
  for (int c = 0; c < count; ++c) {
    const double cosine = dot(own, normalized(given[c]));
    before += cosine > 0;
    flat += std::abs(cosine) >= kCosFlat;
  }
  if (before != 0 && before != count) return NormalsGiven::kContrary;
  if (flat == count) return NormalsGiven::kFlat;
  for (int c = 0; c < count; ++c) {
    const uint32_t code = octahedral_code(before == 0 ? -given[c] : given[c]);
    const auto [known, is_new] = place_.insert({code, static_cast<uint32_t>(scene_->normals.size())});
    if (is_new) scene_->normals.push_back(octahedral_vector(code));
    polygon->normals[c] = known->second;
  }
  return NormalsGiven::kSmooth;
}

void smooth_by_faces(const SmoothFaces& faces, SmoothNormals* normals, Scene* scene) {
  const double cos_angle = std::cos(faces.angle);
  const auto wanted = [&](uint32_t p) {
    return !scene->polygons[p].is_smooth() && faces.groups[p] != kNone &&
           (faces.groups[p] > 0 || faces.angle > 0);
  };
  std::vector<Vec3> own;
  for (const Polygon& polygon : scene->polygons) own.push_back(polygon_normal(*scene, polygon));
  const auto one_surface = [&](uint32_t p, uint32_t q) {
    if (p == q) return true;
    if (!wanted(q) || body_of(*scene, scene->polygons[p]) != body_of(*scene, scene->polygons[q]))
      return false;
    if (faces.groups[p] > 0 || faces.groups[q] > 0) return faces.groups[p] == faces.groups[q];
    return dot(own[p], own[q]) >= cos_angle;
  };
  std::vector<std::array<Vec3, 4>> at_corners(scene->polygons.size());
  const CornersByPosition by = corners_by_position(*scene);
  for (size_t i = 0; i + 1 < by.begins.size(); ++i) {
    for (size_t a = by.begins[i]; a < by.begins[i + 1]; ++a) {
      const CornerAt& corner = by.corners[a];
      if (!wanted(corner.polygon)) continue;
      Vec3 sum;
      for (size_t b = by.begins[i]; b < by.begins[i + 1]; ++b) {
        const CornerAt& other = by.corners[b];
        if (one_surface(corner.polygon, other.polygon))
          sum = sum + angle_at(*scene, other) * own[other.polygon];
      }
      // Surfaces that fold onto themselves have no mean.
      at_corners[corner.polygon][static_cast<size_t>(corner.corner)] =
          length(sum) > 1e-6 ? sum : own[corner.polygon];
    }
  }
  std::vector<bool> give(scene->polygons.size());
  for (uint32_t p = 0; p < scene->polygons.size(); ++p) give[p] = wanted(p);
  for (uint32_t p = 0; p < scene->polygons.size(); ++p)
    if (give[p]) normals->set(&scene->polygons[p], at_corners[p].data());
}

void smooth_by_angle(double angle, Scene* scene) {
  if (!(angle > 0)) return;
  SmoothNormals normals(scene);
  smooth_by_faces({std::vector<uint32_t>(scene->polygons.size()), angle}, &normals, scene);
}

}  // namespace strad
