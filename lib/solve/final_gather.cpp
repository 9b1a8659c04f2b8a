#include "solve/final_gather.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"

namespace strad {
namespace {

constexpr uint32_t kNothing = 0xfffffffeu;  // the ray leaves the scene: no light, but an open view
constexpr uint32_t kDead = 0xffffffffu;     // a surface that no light reaches

constexpr float kFree = 0.95f;  // a view as open as this is not blocked

// Does the segment from `from` to from + reach * direction meet the box?
bool meets(const Box& box, Vec3 from, Vec3 direction, double reach) {
  double low = 0, high = reach;
  for (int i = 0; i < 3; ++i) {
    const double inverse = 1 / direction[i];
    double a = (box.lower[i] - from[i]) * inverse, b = (box.upper[i] - from[i]) * inverse;
    if (a > b) std::swap(a, b);
    if (a > low) low = a;
    if (b < high) high = b;
  }
  return low <= high;
}

}  // namespace

FinalGather::FinalGather(const NodeTree& tree, const Tracer& tracer, const TimeGrid& grid,
                         const SweptBounds& swept, const std::vector<std::vector<Rgb>>& radiance, int rays)
    : tree_(tree), tracer_(tracer), grid_(grid), swept_(swept), radiance_(radiance), ray_count_(rays) {
  const size_t bodies = tree.scene().bodies.size();
  for (size_t b = 0; b < bodies; ++b) {
    moving_mask_.push_back(swept.moves(static_cast<uint32_t>(b)));
    still_mask_.push_back(!moving_mask_.back());
  }
  for (const uint32_t body : swept.moving_bodies()) {
    Box box;
    for (uint32_t c = 0; c < grid.cell_count(); ++c) box.add(swept.box(body, {c, 0}));
    swept_boxes_.push_back(box);
  }
}

// Cosine-distributed about the normal, rest: R2 points on the disk (Malley's method), shifted for each point.
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
    const Point2 xi = r2_point(static_cast<uint32_t>(ray), unit_from(mix64(receiver.seed + 2)),
                               unit_from(mix64(receiver.seed + 3)));
    // Not in step with the directions, which follow the same sequence.
    const uint64_t h = hash_of(receiver.seed, static_cast<uint64_t>(ray));
    at = point_on_patch(receiver.patch, 0.02 + 0.96 * xi.v, 0.02 + 0.96 * unit_from(h));
  }
  return at + tracer_.offset() * receiver.normal;
}

uint32_t FinalGather::leaf_of(const SurfaceHit& hit) const {
  if (hit.polygon == kNone) return kNothing;
  const uint32_t leaf = tree_.leaf_at(hit.polygon, hit.front ? 0 : 1, hit.rest_point);
  return leaf == kNone || radiance_[leaf].empty() ? kDead : leaf;
}

void FinalGather::add(uint32_t leaf, uint32_t first_date, uint32_t date_count, const float* weights,
                      GatheredFunction* to) const {
  if (leaf == kNothing) return;
  if (leaf == kDead) {
    for (uint32_t i = 0; i < date_count; ++i) to->open[first_date + i] -= weights[i];
    return;
  }
  const Rgb* from = radiance_[leaf].data() + first_date;
  for (uint32_t i = 0; i < date_count; ++i) to->irradiance[first_date + i] += weights[i] * from[i];
}

GatheredFunction FinalGather::at_rest(const Receiver& receiver, uint64_t* rays) const {
  const std::vector<Pose>& poses = swept_.cell_begin_poses(0);
  const uint32_t cells = grid_.cell_count(), order = static_cast<uint32_t>(grid_.order);
  const Pose& pose = poses[receiver.body];
  GatheredFunction sum{std::vector<Rgb>(grid_.node_count()), std::vector<float>(grid_.node_count(), 1.0f)};
  const float share = 1.0f / static_cast<float>(ray_count_);
  std::vector<uint32_t> always;  // leaves seen at all dates
  std::vector<float> weights(grid_.node_count());
  std::vector<uint32_t> at_begin(cells), at_end(cells);
  for (int r = 0; r < ray_count_; ++r) {
    const Vec3 from = pose * origin(receiver, r), towards = rotate(pose, direction(receiver, r));
    const SurfaceHit behind = tracer_.closest_of(poses, still_mask_, from, towards, 1e30);
    ++*rays;
    const uint32_t behind_leaf = leaf_of(behind);
    const double reach = behind.polygon == kNone ? 1e30 : behind.distance;
    bool may_meet = false;
    for (const Box& box : swept_boxes_) may_meet = may_meet || meets(box, from, towards, reach);
    if (!may_meet) {
      always.push_back(behind_leaf);
      continue;
    }
    // What the ray sees at both ends of each cell.
    bool changes = false;
    const auto seen_at = [&](uint32_t cell, const std::vector<Pose>& at) {
      bool near = false;
      for (size_t body = 0; body < swept_boxes_.size(); ++body)
        near = near || meets(swept_.cell_box(body, cell), from, towards, reach);
      if (!near) return behind_leaf;
      ++*rays;
      const SurfaceHit hit = tracer_.closest_of(at, moving_mask_, from, towards, reach);
      if (hit.polygon == kNone) return behind_leaf;
      changes = true;
      return leaf_of(hit);
    };
    for (uint32_t c = 0; c < cells; ++c) {
      const bool first_of_span = grid_.spans[span_of_cell(grid_, c)].first_cell == c;
      at_begin[c] = first_of_span ? seen_at(c, swept_.cell_begin_poses(c)) : at_end[c - 1];
      at_end[c] = seen_at(c, swept_.cell_end_poses(c));
    }
    if (!changes) {
      always.push_back(behind_leaf);
      continue;
    }
    // Runs of cells that see the same leaf all along are added at once; elsewhere both ends are blended.
    for (uint32_t c = 0; c < cells;) {
      uint32_t run = c;
      while (run < cells && at_begin[run] == at_begin[c] && at_end[run] == at_begin[c]) ++run;
      if (run > c) {
        std::fill_n(weights.begin(), (run - c) * order, share);
        add(at_begin[c], c * order, (run - c) * order, weights.data(), &sum);
        c = run;
        continue;
      }
      for (uint32_t k = 0; k < order; ++k)
        weights[k] = share * static_cast<float>(1 - gauss_nodes(grid_.order)[k]);
      add(at_begin[c], c * order, order, weights.data(), &sum);
      for (uint32_t k = 0; k < order; ++k) weights[k] = share - weights[k];
      add(at_end[c], c * order, order, weights.data(), &sum);
      ++c;
    }
  }
  std::sort(always.begin(), always.end());
  for (size_t i = 0; i < always.size();) {
    size_t j = i;
    while (j < always.size() && always[j] == always[i]) ++j;
    std::fill(weights.begin(), weights.end(), share * static_cast<float>(j - i));
    add(always[i], 0, grid_.node_count(), weights.data(), &sum);
    i = j;
  }
  return sum;
}

GatheredFunction FinalGather::in_motion(const Receiver& receiver, uint64_t* rays) const {
  const uint32_t order = static_cast<uint32_t>(grid_.order);
  GatheredFunction sum{std::vector<Rgb>(grid_.node_count()), std::vector<float>(grid_.node_count(), 1.0f)};
  // Two sets of rays are blended at each date, so half of the rays in each give the same noise.
  const int ray_count = std::max(1, ray_count_ / 2);
  const float share = 1.0f / static_cast<float>(ray_count);
  const auto look = [&](const std::vector<Pose>& poses) {
    const Pose& pose = poses[receiver.body];
    std::vector<uint32_t> seen;
    for (int r = 0; r < ray_count; ++r)
      seen.push_back(
          leaf_of(tracer_.closest(poses, pose * origin(receiver, r), rotate(pose, direction(receiver, r)))));
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
      const uint32_t dates = step * order;
      weights.resize(2 * dates);
      const auto blend = [&](const std::vector<uint32_t>& seen, bool rising) {
        for (size_t i = 0; i < seen.size();) {
          size_t j = i;
          while (j < seen.size() && seen[j] == seen[i]) ++j;
          for (uint32_t d = 0; d < dates; ++d) {
            const double s = (d / order + gauss_nodes(grid_.order)[d % order]) / step;
            weights[d] = share * static_cast<float>(j - i) * static_cast<float>(rising ? s : 1 - s);
          }
          add(seen[i], first * order, dates, weights.data(), &sum);
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

FinalGather::Receiver FinalGather::receiver_of_vertex(uint32_t vertex) const {
  const MeshBuilder& builder = tree_.builder();
  const Face& face = builder.mesh().faces[builder.face_of_vertex(vertex)];
  const Polygon& polygon = tree_.scene().polygons[face.polygon];
  Receiver receiver;
  receiver.position = builder.sample_point(vertex);
  receiver.normal = (face.side == 0 ? 1.0 : -1.0) * polygon_normal(tree_.scene(), polygon);
  receiver.body = body_of(tree_.scene(), polygon);
  receiver.seed = hash_of(vertex);
  return receiver;
}

FinalGather::Receiver FinalGather::receiver_of_node(uint32_t node) const {
  const Node& n = tree_.nodes()[node];
  Receiver receiver;
  receiver.position = n.centre;
  receiver.normal = n.normal;
  receiver.body = n.body;
  receiver.seed = hash_of(node, 1);
  receiver.spread = true;
  receiver.patch = patch_points(tree_, n);
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
  // Where most of the view is blocked by dead surfaces the point is buried: its neighbours will speak for it.
  for (size_t i = 0; i < f.irradiance.size(); ++i)
    f.irradiance[i] = (1 / std::max(f.open[i], 0.1f)) * f.irradiance[i];
  if (*std::min_element(f.open.begin(), f.open.end()) > kFree) f.open = {};
  return f;
}

GatheredFunction FinalGather::over_node(uint32_t node, uint64_t* rays) const {
  return gather(receiver_of_node(node), rays);
}

FinalGather::View FinalGather::view_of(uint32_t node, uint64_t* rays) const {
  const Receiver receiver = receiver_of_node(node);
  const std::vector<Pose>& poses = swept_.cell_begin_poses(grid_.cell_count() / 2);
  const Pose& pose = poses[receiver.body];
  int lit = 0, dead = 0;
  for (int r = 0; r < ray_count_; ++r) {
    const uint32_t leaf =
        leaf_of(tracer_.closest(poses, pose * origin(receiver, r), rotate(pose, direction(receiver, r))));
    dead += leaf == kDead;
    lit += leaf != kDead && leaf != kNothing;
  }
  *rays += static_cast<uint64_t>(ray_count_);
  const auto all = static_cast<float>(ray_count_);
  return {static_cast<float>(lit) / all, static_cast<float>(dead) / all};
}

}  // namespace strad
