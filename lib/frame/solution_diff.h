// Differences of two solutions, and jumps of one over time. Radiance is laid out as a picture with one row
// for each surface point and one column for each instant, so that the metrics of pictures apply to it.
#pragma once

#include <string>
#include <vector>

#include "frame/surface_samples.h"
#include "image/metrics.h"
#include "solution/solution.h"

namespace strad {

// Radiance in W / (sr m^2): the pixel (x, y) is that of samples[y] at times[x], which ascend.
Image radiance_of(const Scene& scene, const Solution& solution, const std::vector<RestSample>& samples,
                  const std::vector<double>& times, bool continuous = true);

struct NamedSolution {
  std::string name;  // of the file, for errors
  const Scene& scene;
  const Solution& solution;
};

struct SolutionsComparison {
  double begin = 0, end = 0;  // s: the time that both cover
  Comparison total;
  // Where the largest difference is.
  std::string object;
  Vec3 rest_point;
  double time = 0;
};

// Compares `b` to the reference `a` at points on all sides that light reaches in either, spread evenly by
// area, and at instants spread evenly over the time that both cover. Throws BadInput when that is empty or
// the geometry is not the same.
SolutionsComparison compare_solutions(const NamedSolution& a, const NamedSolution& b);

// RMS over the surfaces of L(x, time+) - L(x, time-), over the mean radiance.
struct Jump {
  double as_solved = 0;
  double continuous = 0;  // after the correction that frames are made with
};
// Throws BadInput unless `time` is inside the time of the solution.
Jump jump_of(const NamedSolution& solution, double time);

}  // namespace strad
