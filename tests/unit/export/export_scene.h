// Small lit scenes for the tests of exports.
#pragma once

#include <functional>
#include <vector>

#include "export/mesh.h"
#include "scene/scene.h"
#include "solution/solution.h"
#include "solve/mesh/mesh_builder.h"

namespace strad {

// A unit square in z = 0, front towards +z, corner 0 at the origin; material 0 reflects a half.
inline Scene square_scene() {
  Scene scene;
  scene.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  scene.materials = {{.name = "white", .emission = {}}};
  scene.objects = {{.name = "square", .body = 0}};
  scene.polygons = {{.corners = {0, 1, 2, 3}}};
  scene.start = 0;
  scene.end = 1;
  scene.rate = 10;
  scene.cameras = {{.name = "main", .keys = {{.from = {0.5, 0.5, 2}, .to = {0.5, 0.5, 0}}}}};
  return scene;
}

// A still solution whose vertices have the values that `direct` and `indirect` give at their places.
inline Slab lit_slab(const Scene& scene, Mesh mesh, const std::function<Rgb(Vec3)>& direct,
                     const std::function<Rgb(Vec3)>& indirect) {
  Slab slab;
  slab.grid = make_time_grid(scene.start, scene.end, {}, 1, 1);
  slab.mesh = std::move(mesh);
  const auto fill = [&](const std::function<Rgb(Vec3)>& value, Field* field) {
    field->order = 1;
    for (const MeshVertex& vertex : slab.mesh.vertices) {
      Rgb surplus = value(vertex.position);
      const int parents = vertex.parents[0] == kNone ? 0 : vertex.parents[2] == kNone ? 2 : 4;
      for (int i = 0; i < parents; ++i) {
        surplus +=
            (-1.0f / static_cast<float>(parents)) * value(slab.mesh.vertices[vertex.parents[i]].position);
      }
      field->pieces.push_back({0, 0});
      field->coefficients.push_back(surplus);
      field->first_piece.push_back(static_cast<uint32_t>(field->pieces.size()));
    }
  };
  fill(direct, &slab.direct);
  fill(indirect, &slab.indirect);
  return slab;
}

inline Rgb grey(double value) {
  const auto v = static_cast<float>(value);
  return {v, v, v};
}

}  // namespace strad
