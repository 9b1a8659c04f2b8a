// Elements of a mesh, and where its values come from.
#include "solution/mesh.h"

namespace strad {

int corners_of(const Scene& scene, const Polygon& polygon, const Mesh& mesh, const Element& element,
               Vec3* corners) {
  const int count = element.corner_count();
  for (int i = 0; i < count; ++i)
    corners[i] = is_uniform(element) ? scene.vertices[polygon.corners[i]]
                                     : mesh.vertices[element.vertices[i]].position;
  return count;
}

uint32_t quad_child(Vec2* uv) {
  const bool right = uv->x >= 0.5, top = uv->y >= 0.5;
  *uv = {2 * uv->x - right, 2 * uv->y - top};
  return top ? (right ? 2 : 3) : (right ? 1 : 0);
}

uint32_t triangle_child(Vec2* uv) {
  const double u = 2 * uv->x, v = 2 * uv->y;
  if (u >= 1) return *uv = {u - 1, v}, 1;
  if (v >= 1) return *uv = {u, v - 1}, 2;
  if (u + v <= 1) return *uv = {u, v}, 0;
  return *uv = {1 - u, 1 - v}, 3;
}

MeshPoint locate(const Mesh& mesh, uint32_t face, Vec2 uv) {
  uint32_t element = mesh.faces[face].element;
  const bool quad = mesh.elements[element].corner_count() == 4;
  while (mesh.elements[element].first_child != kNone) {
    element = mesh.elements[element].first_child + (quad ? quad_child(&uv) : triangle_child(&uv));
  }
  const Element& leaf = mesh.elements[element];
  MeshPoint point;
  point.element = element;
  std::copy(leaf.vertices, leaf.vertices + 4, point.vertices);
  const float u = static_cast<float>(uv.x), v = static_cast<float>(uv.y);
  const float of_quad[4] = {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
  const float of_triangle[4] = {1 - u - v, u, v, 0};
  std::copy(quad ? of_quad : of_triangle, (quad ? of_quad : of_triangle) + 4, point.weights);
  return point;
}

}  // namespace strad
