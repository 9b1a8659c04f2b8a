#include "solve/gather/final_gather.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/rng.h"

namespace strad {
namespace {

constexpr uint32_t kEmpty = 0xfffffffeu;  // the ray leaves the scene: no light, but an open view
constexpr uint32_t kUnlit = 0xffffffffu;  // a surface that no light reaches

constexpr float kFree = 0.95f;  // a view as open as this is not blocked

}  // namespace

FinalGather::FinalGather(const NodeTree& tree, const Tracer& tracer, const TimeGrid& grid,
                         const SweptBounds& swept, const FunctionBlock& radiance, int rays)
    : tree_(tree), tracer_(tracer), grid_(grid), swept_(swept), radiance_(radiance), rays_(rays) {
  const size_t bodies = tree.scene().bodies.size();
  for (size_t b = 0; b < bodies; ++b) {
    moving_mask_.push_back(swept.moves(static_cast<uint32_t>(b)));
    still_mask_.push_back(!moving_mask_.back());
  }
}

// Cosine-distributed about the normal, rest: R2 points on the disk (Malley 1988), shifted for each point.
Vec3 FinalGather::direction(const Receiver& receiver, int ray) const {
  const double u0 = unit_from(mix64(receiver.seed)), v0 = unit_from(mix64(receiver.seed + 1));
  const Point2 xi = r2_point(static_cast<uint32_t>(ray), u0, v0);
  const double r = std::sqrt(xi.u), phi = 2 * kPi * xi.v;
  const Frame frame = frame_about(receiver.normal);
  return r * std::cos(phi) * frame.tangent + r * std::sin(phi) * frame.bitangent +
         std::sqrt(std::max(0.0, 1 - xi.u)) * frame.normal;
}

Vec3 FinalGather::origin(const Receiver& receiver, int ray) const {
  Vec3 at = receiver.position;
  if (receiver.spread) {
    // Other ratios than those of the directions, so that neither coordinate is in step with one of them: two
    // of the R4 sequence (Roberts 2018), powers of 1 / 1.1673.
    constexpr double kRatios[2] = {0.6287067210378087, 0.5385972572236101};
    constexpr double kRim = 0.002;  // not on the rim, where surfaces meet
    double xi[2];
    for (uint64_t i = 0; i < 2; ++i) {
      const double shifted = unit_from(mix64(receiver.seed + 2 + i)) + kRatios[i] * (ray + 1);
      xi[i] = kRim + (1 - 2 * kRim) * (shifted - std::floor(shifted));
    }
    at = point_on_patch(receiver.patch, xi[0], xi[1]);
  }
  return at + tracer_.offset() * receiver.normal;
}

uint32_t FinalGather::leaf_of(const SurfaceHit& hit) const {
  if (hit.polygon == kNone) return kEmpty;
  const uint32_t leaf = tree_.leaf_at(hit.polygon, hit.front ? 0 : 1, hit.rest_point);
  return leaf == kNone ? kUnlit : leaf;
}

void FinalGather::add(uint32_t leaf, uint32_t first_sample, uint32_t sample_count, const float* weights,
                      GatheredFunction* to) const {
  if (leaf == kEmpty) return;
  if (leaf == kUnlit) {
    for (uint32_t i = 0; i < sample_count; ++i) to->unblocked[first_sample + i] -= weights[i];
    return;
  }
  radiance_.add(leaf, first_sample, sample_count, weights, &to->irradiance[first_sample]);
}

GatheredFunction FinalGather::at_rest(const Receiver& receiver, uint64_t* rays) const {
  const std::vector<Pose>& poses = swept_.cell_begin_poses(0);
  const Pose& pose = poses[receiver.body];
  GatheredFunction sum{std::vector<Rgb>(grid_.sample_count()),
                       std::vector<float>(grid_.sample_count(), 1.0f)};
  const float share = 1.0f / static_cast<float>(receiver.rays);
  std::vector<uint32_t> always;  // leaves seen at all time samples
  std::vector<CellEnds> seen(grid_.cell_count());
  for (int r = 0; r < receiver.rays; ++r) {
    const Vec3 from = pose * origin(receiver, r), towards = rotate(pose, direction(receiver, r));
    const SurfaceHit behind = tracer_.closest_of(poses, still_mask_, from, towards, 1e30);
    ++*rays;
    if (meets_movers(from, towards, behind, &seen, rays))
      add_seen(seen, share, &sum);
    else
      always.push_back(leaf_of(behind));
  }
  add_always(std::move(always), share, &sum);
  return sum;
}

// What a ray sees at both ends of each cell, where `behind` is what it meets of what rests. False if no
// moving body ever comes before that.
bool FinalGather::meets_movers(Vec3 from, Vec3 towards, const SurfaceHit& behind, std::vector<CellEnds>* seen,
                               uint64_t* rays) const {
  const double reach = behind.polygon == kNone ? 1e30 : behind.distance;
  if (!swept_.may_meet(from, towards, reach)) return false;
  const uint32_t behind_leaf = leaf_of(behind);
  bool meets = false;
  const auto seen_at = [&](uint32_t cell, const std::vector<Pose>& poses) {
    if (!swept_.may_meet_in(cell, from, towards, reach)) return behind_leaf;
    ++*rays;
    const SurfaceHit hit = tracer_.closest_of(poses, moving_mask_, from, towards, reach);
    if (hit.polygon == kNone) return behind_leaf;
    meets = true;
    return leaf_of(hit);
  };
  for (uint32_t c = 0; c < seen->size(); ++c) {
    const bool first_of_span = grid_.spans[span_of_cell(grid_, c)].first_cell == c;
    (*seen)[c].begin = first_of_span ? seen_at(c, swept_.cell_begin_poses(c)) : (*seen)[c - 1].end;
    (*seen)[c].end = seen_at(c, swept_.cell_end_poses(c));
  }
  return meets;
}

// Adds runs of cells in which a ray sees the same leaf at once; elsewhere blends what it sees at both ends.
void FinalGather::add_seen(const std::vector<CellEnds>& seen, float share, GatheredFunction* sum) const {
  const auto cells = static_cast<uint32_t>(seen.size()), order = static_cast<uint32_t>(grid_.order);
  std::vector<float> weights(grid_.sample_count());
  for (uint32_t c = 0; c < cells;) {
    uint32_t run = c;
    while (run < cells && seen[run].begin == seen[c].begin && seen[run].end == seen[c].begin) ++run;
    if (run > c) {
      std::fill_n(weights.begin(), (run - c) * order, share);
      add(seen[c].begin, c * order, (run - c) * order, weights.data(), sum);
      c = run;
      continue;
    }
    for (uint32_t k = 0; k < order; ++k)
      weights[k] = share * static_cast<float>(1 - gauss_nodes(grid_.order)[k]);
    add(seen[c].begin, c * order, order, weights.data(), sum);
    for (uint32_t k = 0; k < order; ++k) weights[k] = share - weights[k];
    add(seen[c].end, c * order, order, weights.data(), sum);
    ++c;
  }
}

// Adds the leaves that rays see at all time samples, each once with the number of its rays.
void FinalGather::add_always(std::vector<uint32_t> leaves, float share, GatheredFunction* sum) const {
  std::vector<float> weights(grid_.sample_count());
  std::sort(leaves.begin(), leaves.end());
  for (size_t i = 0; i < leaves.size();) {
    size_t j = i;
    while (j < leaves.size() && leaves[j] == leaves[i]) ++j;
    std::fill(weights.begin(), weights.end(), share * static_cast<float>(j - i));
    add(leaves[i], 0, grid_.sample_count(), weights.data(), sum);
    i = j;
  }
}

GatheredFunction FinalGather::in_motion(const Receiver& receiver, uint64_t* rays) const {
  const uint32_t order = static_cast<uint32_t>(grid_.order);
  GatheredFunction sum{std::vector<Rgb>(grid_.sample_count()),
                       std::vector<float>(grid_.sample_count(), 1.0f)};
  // Two sets of rays are blended at each time sample, so half of the rays in each give the same noise.
  const int ray_count = std::max(1, receiver.rays / 2);
  const float share = 1.0f / static_cast<float>(ray_count);
  std::vector<std::pair<Vec3, Vec3>> rest_rays;  // the same at all time samples
  for (int r = 0; r < ray_count; ++r) rest_rays.emplace_back(origin(receiver, r), direction(receiver, r));
  const auto look = [&](const std::vector<Pose>& poses) {
    const Pose& pose = poses[receiver.body];
    std::vector<uint32_t> seen;
    for (const auto& [from, towards] : rest_rays)
      seen.push_back(leaf_of(tracer_.closest(poses, pose * from, rotate(pose, towards))));
    *rays += static_cast<uint64_t>(ray_count);
    std::sort(seen.begin(), seen.end());
    return seen;
  };
  std::vector<float> weights;
  for (const Span& span : grid_.spans) {
    const uint32_t cells = 1u << span.log2_cells;
    const uint32_t step = std::max(1u, cells / 32);
    std::vector<uint32_t> before = look(swept_.cell_begin_poses(span.first_cell));
    for (uint32_t c = 0; c < cells; c += step) {
      const uint32_t first = span.first_cell + c;
      std::vector<uint32_t> after = look(swept_.cell_end_poses(first + step - 1));
      const uint32_t time_samples = step * order;
      weights.resize(2 * time_samples);
      const auto blend = [&](const std::vector<uint32_t>& seen, bool rising) {
        for (size_t i = 0; i < seen.size();) {
          size_t j = i;
          while (j < seen.size() && seen[j] == seen[i]) ++j;
          for (uint32_t d = 0; d < time_samples; ++d) {
            const double s = (d / order + gauss_nodes(grid_.order)[d % order]) / step;
            weights[d] = share * static_cast<float>(j - i) * static_cast<float>(rising ? s : 1 - s);
          }
          add(seen[i], first * order, time_samples, weights.data(), &sum);
          i = j;
        }
      };
      blend(before, false);
      blend(after, true);
      before = std::move(after);
    }
  }
  return sum;
}

FinalGather::Receiver FinalGather::receiver_on(uint32_t face, Vec3 position, uint64_t seed) const {
  const MeshBuilder& builder = tree_.builder();
  Receiver receiver;
  receiver.position = position;
  receiver.normal = tree_.face_normal(face);
  receiver.body = body_of(tree_.scene(), tree_.scene().polygons[builder.mesh().faces[face].polygon]);
  receiver.seed = seed;
  receiver.rays = static_cast<int>(builder.accuracy_share(face) * rays_);
  return receiver;
}

FinalGather::Receiver FinalGather::receiver_of_vertex(uint32_t vertex) const {
  const MeshBuilder& builder = tree_.builder();
  const uint32_t face = builder.face_of_vertex(vertex);
  if (is_uniform(builder.mesh().elements[builder.mesh().faces[face].element])) return receiver_of_face(face);
  Receiver receiver = receiver_on(face, builder.sample_point(vertex), hash_of(vertex));
  if (vertex < builder.undivided_vertices()) {
    receiver.spread = true;
    receiver.patch = part_at_vertex(face, vertex);
  }
  return receiver;
}

// The part of an undivided face that is nearest to one of its vertices: the corner, the middles of the edges
// that meet there, and the middle of the face.
PatchPoints FinalGather::part_at_vertex(uint32_t face, uint32_t vertex) const {
  const Face& f = tree_.builder().mesh().faces[face];
  const PatchPoints points = face_points(tree_.scene(), f);
  const uint32_t* vertices = tree_.builder().mesh().elements[f.element].vertices;
  const int n = points.corner_count,
            c = static_cast<int>(std::find(vertices, vertices + n, vertex) - vertices);
  const Vec3 corner = points.corners[c];
  Vec3 middle;
  for (int i = 0; i < n; ++i) middle += points.corners[i] / n;
  return {{corner, lerp(corner, points.corners[(c + 1) % n], 0.5), middle,
           lerp(corner, points.corners[(c + n - 1) % n], 0.5)},
          4};
}

FinalGather::Receiver FinalGather::receiver_of_patch(const Node& n) const {
  Receiver receiver = receiver_on(n.face, n.centre, hash_of(n.element, 1));
  receiver.spread = true;
  receiver.patch = patch_points(tree_, n);
  return receiver;
}

FinalGather::Receiver FinalGather::receiver_of_face(uint32_t face) const {
  Receiver receiver = receiver_on(face, {}, hash_of(face, 2));
  receiver.spread = true;
  receiver.patch = face_points(tree_.scene(), tree_.builder().mesh().faces[face]);
  return receiver;
}

GatheredFunction FinalGather::gather(const Receiver& receiver, uint64_t* rays) const {
  GatheredFunction f = swept_.moves(receiver.body) && grid_.cell_count() > 1 ? in_motion(receiver, rays)
                                                                             : at_rest(receiver, rays);
  for (Rgb& e : f.irradiance) e = static_cast<float>(kPi) * e;
  return f;
}

GatheredFunction FinalGather::at_vertex(uint32_t vertex, uint64_t* rays) const {
  GatheredFunction f = gather(receiver_of_vertex(vertex), rays);
  // A point with most of its view blocked lies inside something. Its value will be replaced by its
  // neighbours'.
  for (size_t i = 0; i < f.irradiance.size(); ++i)
    f.irradiance[i] = (1 / std::max(f.unblocked[i], 0.1f)) * f.irradiance[i];
  if (*std::min_element(f.unblocked.begin(), f.unblocked.end()) > kFree) f.unblocked = {};
  return f;
}

GatheredFunction FinalGather::over_leaf(uint32_t leaf, uint64_t* rays) const {
  const size_t nodes = tree_.nodes().size();
  return gather(leaf < nodes ? receiver_of_patch(tree_.nodes()[leaf])
                             : receiver_of_face(leaf - static_cast<uint32_t>(nodes)),
                rays);
}

FinalGather::View FinalGather::view_of(const Receiver& receiver) const {
  const std::vector<Pose>& poses = swept_.cell_begin_poses(grid_.cell_count() / 2);
  const Pose& pose = poses[receiver.body];
  int lit = 0, unlit = 0;
  for (int r = 0; r < receiver.rays; ++r) {
    const uint32_t leaf =
        leaf_of(tracer_.closest(poses, pose * origin(receiver, r), rotate(pose, direction(receiver, r))));
    unlit += leaf == kUnlit;
    lit += leaf != kUnlit && leaf != kEmpty;
  }
  const auto all = static_cast<float>(receiver.rays);
  return {static_cast<float>(lit) / all, static_cast<float>(unlit) / all};
}

FinalGather::View FinalGather::view_of(uint32_t n, uint64_t* rays) const {
  const Node& node = tree_.nodes()[n];
  *rays += static_cast<uint64_t>(rays_);
  if (!node.is_cluster()) {
    Receiver receiver = receiver_of_patch(node);
    receiver.rays = rays_;
    return view_of(receiver);
  }
  View mean{0, 0};
  for (int s = 0; s < Cluster::kSamples; ++s) {
    const SurfaceSample& sample = tree_.cluster(node).samples[s];
    Receiver receiver;
    receiver.position = sample.position;
    receiver.normal = sample.normal;
    receiver.body = node.body;
    receiver.seed = hash_of(n, 4, static_cast<uint64_t>(s));
    receiver.rays = std::max(1, rays_ / Cluster::kSamples);
    const View view = view_of(receiver);
    mean.lit += view.lit / Cluster::kSamples;
    mean.unlit += view.unlit / Cluster::kSamples;
  }
  return mean;
}

}  // namespace strad
