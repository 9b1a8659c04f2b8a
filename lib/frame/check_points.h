// Where and when a solution is checked: points of surfaces by area, or as the pixels of a camera see them,
// and instants spread over time.
#pragma once

#include <cstdint>
#include <vector>

#include "frame/frame_list.h"
#include "frame/probe.h"
#include "frame/surfaces.h"

namespace strad {

struct CheckPoint {
  ProbePoint place;
  double time = 0;     // s
  double weight = 0;   // the area or the part of the picture that it stands for; only ratios count
  bool meshed = true;  // the solution has light on this side at some time
};

// Of the sides with meshed[2 * polygon + side] `count` points, stratified by area and by time; of the others,
// which the solution takes for dark, an eighth as many. Surfaces that reflect nothing have none. Means over
// the points by weight are unbiased; equal seeds give equal points.
std::vector<CheckPoint> points_by_area(const Scene& scene, const std::vector<bool>& meshed, TimeRange range,
                                       uint32_t count, uint64_t seed);

// What `count` positions of a picture, stratified by place and time, show of surfaces that reflect: fewer
// points where they show something else.
std::vector<CheckPoint> points_by_camera(const Scene& scene, const Surfaces& surfaces, const Camera& camera,
                                         PictureSize size, TimeRange range, uint32_t count, uint64_t seed);

}  // namespace strad
