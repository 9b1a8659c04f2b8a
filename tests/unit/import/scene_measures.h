// Sizes of what was imported: area, volume, normals.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "scene/scene.h"

namespace strad {

inline double area_of(const Scene& scene) {
  double area = 0;
  for (const Polygon& p : scene.polygons) {
    const auto& v = scene.vertices;
    const Vec3 a = v[p.corners[0]], b = v[p.corners[1]], c = v[p.corners[2]];
    area += length(cross(b - a, c - a)) / 2;
    if (p.corner_count() == 4) area += length(cross(c - a, v[p.corners[3]] - a)) / 2;
  }
  return area;
}

// By the divergence theorem; positive if fronts look outwards.
inline double volume_of(const Scene& scene) {
  double volume = 0;
  for (const Polygon& p : scene.polygons) {
    const auto& v = scene.vertices;
    for (int k = 2; k < p.corner_count(); ++k)
      volume += dot(v[p.corners[0]], cross(v[p.corners[k - 1]], v[p.corners[k]])) / 6;
  }
  return volume;
}

// Distance of a normal from the direction that is expected at its place, the largest of all.
inline double worst_normal(const Scene& scene, const std::function<Vec3(Vec3)>& expected) {
  double worst = 0;
  for (const Polygon& polygon : scene.polygons)
    for (int c = 0; polygon.is_smooth() && c < polygon.corner_count(); ++c)
      worst = std::max(worst, length(scene.normals[polygon.normals[c]] -
                                     normalized(expected(scene.vertices[polygon.corners[c]]))));
  return worst;
}

inline void expect_near(Vec3 found, Vec3 expected, double tolerance = 1e-5) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(found[axis], expected[axis], tolerance) << "axis " << axis;
}

}  // namespace strad
