#include "solve/gather/ray_bundle.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace strad {

GatherSpace::GatherSpace(const NodeTree& node_tree, const Tracer& ray_tracer, const TimeGrid& time_grid,
                         const SweptBounds& swept_bounds, LeafSlopes leaf_slopes,
                         DirectionGuide direction_guide)
    : tree(node_tree),
      tracer(ray_tracer),
      grid(time_grid),
      swept(swept_bounds),
      slopes(std::move(leaf_slopes)),
      guide(std::move(direction_guide)) {
  for (uint32_t b = 0; b < tree.scene().bodies.size(); ++b) {
    moving_mask.push_back(swept.moves(b));
    still_mask.push_back(!moving_mask.back());
  }
}

uint32_t GatherSpace::leaf_of(const SurfaceHit& hit) const {
  if (hit.polygon == kNone) return kOpenView;
  const uint32_t leaf = tree.leaf_at(hit.polygon, hit.front ? 0 : 1, hit.uv);
  return leaf == kNone ? kUnlit : leaf;
}

Seen GatherSpace::seen_at(const SurfaceHit& hit) const {
  if (hit.polygon == kNone) return {kOpenView, 1};
  Vec2 uv = hit.uv;
  const uint32_t leaf = tree.leaf_at(hit.polygon, hit.front ? 0 : 1, &uv);
  if (leaf == kNone) return {kUnlit, 1};
  return {leaf, slopes.factor(leaf, uv)};
}

Seen GatherSpace::seen_through_glass(const std::vector<Pose>& poses, Vec3 from, Vec3 towards,
                                     const std::vector<bool>& mask) const {
  Rgb passed{1, 1, 1};
  Seen seen = seen_at(tracer.closest_through(poses, from, towards, &passed, mask));
  seen.weight *= mean_channel(passed);
  return seen;
}

namespace {

Seen weighted(Seen seen, float weight) {
  seen.weight *= weight;
  return seen;
}

}  // namespace

RayBundle::RayBundle(const GatherSpace& space, const Receiver& receiver, uint64_t* rays)
    : space_(space),
      body_(receiver.body),
      moves_(space.swept.moves(receiver.body) && !is_instant(space.grid)),
      cells_(space.grid.cell_count()),
      rays_(*rays) {
  // Two looks are blended at each time sample, so half of the rays in each give the same noise.
  const int count = moves_ ? std::max(1, receiver.rays / 2) : receiver.rays;
  const std::vector<RestRay> rest_rays =
      rays_of(receiver, space.guide.density(receiver.node), count, space.tracer.offset());
  if (!moves_)
    trace_still(rest_rays);
  else
    for (const RestRay& ray : rest_rays) watched_.push_back({ray, 1e30, {kOpenView, 1}});
}

void RayBundle::trace_still(const std::vector<RestRay>& rest_rays) {
  const std::vector<Pose>& poses = space_.swept.cell_begin_poses(0);
  const Pose& pose = poses[body_];
  active_.resize(cells_);
  for (const RestRay& ray : rest_rays) {
    const Vec3 from = pose * ray.from, towards = rotate(pose, ray.towards);
    double reach = 1e30;
    Seen seen;
    if (space_.tracer.has_glass()) {
      seen = space_.seen_through_glass(poses, from, towards, space_.still_mask);
    } else {
      const SurfaceHit behind = space_.tracer.closest_of(poses, space_.still_mask, from, towards, reach);
      seen = space_.seen_at(behind);
      if (behind.polygon != kNone) reach = behind.distance;
    }
    seen = weighted(seen, ray.weight);
    if (!space_.swept.may_meet(from, towards, reach)) {
      always_.push_back(seen);
      always_rays_.push_back(ray);
      continue;
    }
    watched_.push_back({{from, towards, ray.xi, ray.weight}, reach, seen});
    for (uint32_t c = 0; c < cells_; ++c) {
      const bool meets = space_.swept.may_meet_in(c, from, towards, reach);
      meets_.push_back(meets);
      active_[c] += meets;
    }
  }
  rays_ += rest_rays.size();
}

std::vector<Seen> RayBundle::see(uint32_t span, uint32_t cell) const {
  const uint32_t first = space_.grid.spans[span].first_cell, near = cell == 0 ? first : first + cell - 1;
  const std::vector<Pose>& poses =
      cell == 0 ? space_.swept.cell_begin_poses(near) : space_.swept.cell_end_poses(near);
  std::vector<Seen> seen(watched_.size());
  for (size_t i = 0; i < watched_.size(); ++i) {
    const RestRay& ray = watched_[i].ray;
    if (moves_) {
      ++rays_;
      seen[i] = weighted(
          space_.seen_through_glass(poses, poses[body_] * ray.from, rotate(poses[body_], ray.towards)),
          ray.weight);
      continue;
    }
    seen[i] = watched_[i].behind;
    if (!may_meet(i, near)) continue;
    ++rays_;
    if (space_.tracer.has_glass()) {
      seen[i] = weighted(space_.seen_through_glass(poses, ray.from, ray.towards), ray.weight);
      continue;
    }
    const SurfaceHit hit =
        space_.tracer.closest_of(poses, space_.moving_mask, ray.from, ray.towards, watched_[i].reach);
    if (hit.polygon != kNone) seen[i] = weighted(space_.seen_at(hit), ray.weight);
  }
  return seen;
}

void RayBundle::count(const std::vector<float>& mean_radiance, const std::vector<Look>& looks,
                      DirectionCounts* counts) const {
  const auto brought = [&](const RestRay& ray, const Seen& seen) {
    const bool brings = seen.leaf != kOpenView && seen.leaf != kUnlit;
    return brings ? double{seen.weight} / ray.weight * mean_radiance[seen.leaf] : 0.0;
  };
  for (size_t i = 0; i < always_.size(); ++i) {
    const double b = brought(always_rays_[i], always_[i]);
    counts->add(always_rays_[i].xi, b, b * b);
  }
  for (size_t i = 0; i < watched_.size(); ++i) {
    double sum = 0, squares = 0;
    for (const Look& look : looks) {
      const double b = brought(watched_[i].ray, look.seen[i]);
      sum += b, squares += b * b;
    }
    const auto n = static_cast<double>(looks.size());
    counts->add(watched_[i].ray.xi, sum / n, squares / n);
  }
}

uint32_t RayBundle::surprise(uint32_t first_cell, uint32_t end_cell) const {
  if (active_.empty()) return 0;
  const double begin = active_[first_cell], end = active_[end_cell - 1];
  double most = 0;
  for (uint32_t c = first_cell + 1; c + 1 < end_cell; ++c) {
    const double s = static_cast<double>(c - first_cell) / (end_cell - 1 - first_cell);
    most = std::max(most, std::abs(active_[c] - (begin + s * (end - begin))));
  }
  return static_cast<uint32_t>(most);
}

}  // namespace strad
