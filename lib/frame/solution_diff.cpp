#include "frame/solution_diff.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "scene/texture.h"
#include "scene/trajectory.h"

namespace strad {
namespace {

// 4096 points at 64 instants: the noise of a rel_rmse found with them is below 1 % of it.
constexpr uint32_t kPoints = 4096;
constexpr int kInstants = 64;

// One-sided values are taken this far from an instant, as a fraction of the solution's time. It is more than
// the rounding error of a boundary between pieces, and too little for a continuous function to change.
constexpr double kOneSided = 1e-9;

void mark_lit(const Solution& solution, std::vector<bool>* lit) {
  for (const Slab& slab : solution.slabs)
    for (const Face& face : slab.mesh.faces) (*lit)[2 * face.polygon + face.side] = true;
}

// Where the samples lie in a slab's mesh. The element is kNone on sides that no light reaches.
std::vector<MeshPoint> locate_all(const Scene& scene, const Mesh& mesh,
                                  const std::vector<RestSample>& samples) {
  std::vector<MeshPoint> points(samples.size());
  for (size_t i = 0; i < samples.size(); ++i) {
    const uint32_t face = mesh.face_of_side[2 * samples[i].polygon + samples[i].side];
    if (face != kNone)
      points[i] =
          locate(mesh, face, parametric_of(scene, scene.polygons[samples[i].polygon], samples[i].rest_point));
  }
  return points;
}

Rgb irradiance_at(const VertexLight& light, const MeshPoint& point) {
  Rgb sum;
  for (int i = 0; i < 4; ++i)
    if (point.vertices[i] != kNone)
      sum += point.weights[i] * (light.direct[point.vertices[i]] + light.indirect[point.vertices[i]]);
  return sum;
}

// Times of the golden-ratio sequence (multiples of the golden ratio modulo 1), ascending. They are spread
// evenly, and none is a dyadic fraction, where pieces meet.
std::vector<double> times_in(double begin, double end) {
  if (!(end > begin)) return {begin};
  std::vector<double> times;
  for (int i = 1; i <= kInstants; ++i) {
    const double s = i * 0.6180339887498949;
    times.push_back(begin + (s - std::floor(s)) * (end - begin));
  }
  std::sort(times.begin(), times.end());
  return times;
}

void require_same_geometry(const NamedSolution& a, const NamedSolution& b) {
  const auto refuse = [&](const char* what, size_t found, size_t expected) {
    throw BadInput(b.name + ": found " + std::to_string(found) + " " + what + ", expected " +
                   std::to_string(expected) + " as in " + a.name);
  };
  if (a.scene.polygons.size() != b.scene.polygons.size())
    refuse("polygons", b.scene.polygons.size(), a.scene.polygons.size());
  if (a.scene.vertices.size() != b.scene.vertices.size())
    refuse("vertices", b.scene.vertices.size(), a.scene.vertices.size());
  for (size_t v = 0; v < a.scene.vertices.size(); ++v)
    if (a.scene.vertices[v] != b.scene.vertices[v])
      throw BadInput(b.name + ": found vertex " + std::to_string(v) + " elsewhere than in " + a.name);
  for (size_t p = 0; p < a.scene.polygons.size(); ++p)
    if (!std::ranges::equal(a.scene.polygons[p].corners, b.scene.polygons[p].corners))
      throw BadInput(b.name + ": found polygon " + std::to_string(p) + " with other corners than in " +
                     a.name);
}

double begin_of(const Solution& solution) { return slab_begin(solution.slabs.front()); }
double end_of(const Solution& solution) { return slab_end(solution.slabs.back()); }

std::string seconds_text(double begin, double end) {
  return std::to_string(begin) + " to " + std::to_string(end) + " s";
}

}  // namespace

Image radiance_of(const Scene& scene, const Solution& solution, const std::vector<RestSample>& samples,
                  const std::vector<double>& times, bool continuous) {
  Image image(static_cast<uint32_t>(times.size()), static_cast<uint32_t>(samples.size()));
  const std::vector<Rgb> reflectances = textured_reflectances(scene);
  std::vector<MeshPoint> points;
  uint32_t located = kNone;
  for (uint32_t x = 0; x < image.width; ++x) {
    const uint32_t slab = slab_at(solution, times[x]);
    if (slab != located) points = locate_all(scene, solution.slabs[slab].mesh, samples);
    located = slab;
    const VertexLight light = light_at(solution.slabs[slab], times[x], continuous);
    const std::vector<float> glow = glow_at(scene, times[x]);
    for (uint32_t y = 0; y < image.height; ++y) {
      const uint32_t material = scene.polygons[samples[y].polygon].material;
      const Rgb reflected =
          static_cast<float>(1 / kPi) * (reflectances[material] * irradiance_at(light, points[y]));
      const Rgb emitted = samples[y].side == 0 ? glow[material] * scene.materials[material].emission : Rgb{};
      image.at(x, y) = emitted + reflected;
    }
  }
  return image;
}

SolutionsComparison compare_solutions(const NamedSolution& a, const NamedSolution& b) {
  require_same_geometry(a, b);
  SolutionsComparison result;
  result.begin = std::max(begin_of(a.solution), begin_of(b.solution));
  result.end = std::min(end_of(a.solution), end_of(b.solution));
  if (result.begin > result.end)
    throw BadInput(b.name + ": found a solution of " +
                   seconds_text(begin_of(b.solution), end_of(b.solution)) + ", expected some of " +
                   seconds_text(begin_of(a.solution), end_of(a.solution)) + " as in " + a.name);
  std::vector<bool> lit(2 * a.scene.polygons.size());
  mark_lit(a.solution, &lit);
  mark_lit(b.solution, &lit);
  const std::vector<RestSample> samples = surface_samples(a.scene, lit, kPoints);
  const std::vector<double> times = times_in(result.begin, result.end);
  result.total = compare(radiance_of(a.scene, a.solution, samples, times),
                         radiance_of(b.scene, b.solution, samples, times));
  if (samples.empty()) return result;
  const RestSample& worst = samples[result.total.worst.y];
  result.object = a.scene.objects[a.scene.polygons[worst.polygon].object].name;
  result.rest_point = worst.rest_point;
  result.time = times[result.total.worst.x];
  return result;
}

Jump jump_of(const NamedSolution& of, double time) {
  const double begin = begin_of(of.solution), end = end_of(of.solution);
  if (!(time > begin && time < end))
    throw BadInput(of.name + ": no instant inside its " + seconds_text(begin, end) + ": " +
                   std::to_string(time));
  const double step = kOneSided * (end - begin);
  std::vector<bool> lit(2 * of.scene.polygons.size());
  mark_lit(of.solution, &lit);
  const std::vector<RestSample> samples = surface_samples(of.scene, lit, kPoints);
  const auto jump = [&](bool continuous) {
    const Image before = radiance_of(of.scene, of.solution, samples, {time - step}, continuous);
    return rel_rmse(compare(before, radiance_of(of.scene, of.solution, samples, {time + step}, continuous)));
  };
  return {jump(false), jump(true)};
}

}  // namespace strad
