#include "frame/show_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "image/metrics.h"
#include "scene/polygon_geometry.h"
#include "scene/texture.h"

namespace strad {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
constexpr float kLeftBySplit = 0.25f;

std::vector<Rgb> irradiance_at(const Slab& slab, double time) {
  VertexLight light = light_at(slab, time);
  for (size_t v = 0; v < light.indirect.size(); ++v) light.indirect[v] += light.direct[v];
  return std::move(light.indirect);
}

// What a vertex has beyond the mean of its parents.
std::vector<Rgb> surpluses_of(const Mesh& mesh, const std::vector<Rgb>& irradiance) {
  std::vector<Rgb> surpluses = irradiance;
  for (size_t v = 0; v < mesh.vertices.size(); ++v) {
    const int count = mesh.vertices[v].parent_count();
    for (int i = 0; i < count; ++i)
      surpluses[v] += (-1.0f / static_cast<float>(count)) * irradiance[mesh.vertices[v].parents[i]];
  }
  return surpluses;
}

// By element: luminance of the radiance that irradiance of 1 becomes, by channel.
std::vector<Rgb> reflections_of_elements(const Scene& scene, const Mesh& mesh) {
  const std::vector<Rgb> reflectances = textured_reflectances(scene);
  std::vector<Rgb> reflections(mesh.elements.size());
  for (const Face& face : mesh.faces)
    reflections[face.element] =
        static_cast<float>(1 / kPi) * reflectances[scene.polygons[face.polygon].material];
  for (size_t e = 0; e < mesh.elements.size(); ++e) {  // parents come before their children
    const uint32_t first = mesh.elements[e].first_child;
    if (first != kNone) std::fill_n(reflections.begin() + first, 4, reflections[e]);
  }
  return reflections;
}

// Area-weighted, of the luminance of what leaves reflect.
double mean_reflected(const Scene& scene, const Mesh& mesh, const std::vector<Rgb>& reflections,
                      const std::vector<Rgb>& irradiance) {
  double sum = 0, areas = 0;
  const auto add = [&](const auto& self, const Polygon& polygon, uint32_t e) -> void {
    const Element& element = mesh.elements[e];
    if (element.first_child != kNone) {
      for (uint32_t c = 0; c < 4; ++c) self(self, polygon, element.first_child + c);
      return;
    }
    Vec3 corners[4];
    const int count = corners_of(scene, polygon, mesh, element, corners);
    Rgb mean;
    for (int i = 0; i < count; ++i) mean += (1 / static_cast<float>(count)) * irradiance[element.vertices[i]];
    const double area = area_of(corners, count);
    sum += area * luminance(reflections[e] * mean);
    areas += area;
  };
  for (const Face& face : mesh.faces) add(add, scene.polygons[face.polygon], face.element);
  return areas > 0 ? sum / areas : 0;
}

// The largest surplus of the vertices that splitting has added in and around an element.
float largest_surplus(const Mesh& mesh, const Element& element, Rgb reflection,
                      const std::vector<Rgb>& surpluses) {
  const uint32_t* own = element.vertices;
  float largest = 0;
  for (uint32_t c = 0; c < 4; ++c) {
    const Element& child = mesh.elements[element.first_child + c];
    for (int i = 0; i < child.corner_count(); ++i) {
      const uint32_t v = child.vertices[i];
      if (std::find(own, own + 4, v) == own + 4)
        largest = std::max(largest, std::abs(luminance(reflection * surpluses[v])));
    }
  }
  return largest;
}

}  // namespace

std::vector<float> element_errors(const Scene& scene, const Slab& slab, double time) {
  const Mesh& mesh = slab.mesh;
  const std::vector<Rgb> irradiance = irradiance_at(slab, time), surpluses = surpluses_of(mesh, irradiance);
  const std::vector<Rgb> reflections = reflections_of_elements(scene, mesh);
  const double mean = mean_reflected(scene, mesh, reflections, irradiance);
  std::vector<float> errors(mesh.elements.size(), kUnknown);
  for (size_t e = 0; e < mesh.elements.size(); ++e) {
    const Element& element = mesh.elements[e];
    if (element.first_child == kNone) continue;
    const float largest = largest_surplus(mesh, element, reflections[e], surpluses);
    const float error = mean > 0 ? kLeftBySplit * largest / static_cast<float>(mean) : 0;
    std::fill_n(errors.begin() + element.first_child, 4, error);
  }
  return errors;
}

Image error_values(const ShowView& view, const Slab& slab, double time) {
  const std::vector<float> errors = element_errors(view.scene, slab, time);
  Image image(view.width, view.height);
  parallel_for(view.height, 1, [&](size_t begin, size_t end) {
    for (auto y = static_cast<uint32_t>(begin); y < end; ++y)
      for (uint32_t x = 0; x < view.width; ++x) {
        const Sight sight = view.look(x + 0.5, y + 0.5);
        if (sight.point.polygon == kNone) continue;
        const uint32_t face = face_seen(slab.mesh, sight);
        const float error = face == kNone ? kUnknown : errors[locate(slab.mesh, face, sight.at).element];
        image.at(x, y) = {error, error, error};
      }
  });
  return image;
}

Image error_colours(const Image& values) {
  Image known = values;
  for (Rgb& value : known.pixels)
    if (std::isnan(value.r)) value = {};
  Image colours = heat_map(Image(values.width, values.height), known, kFullError);
  for (size_t i = 0; i < values.pixels.size(); ++i)
    if (std::isnan(values.pixels[i].r)) colours.pixels[i] = {kNoMeshGrey, kNoMeshGrey, kNoMeshGrey};
  return colours;
}

}  // namespace strad
