// What a check found: the error as a whole, by body, material, brightness and time, and where it is worst.
#pragma once

#include <string>
#include <vector>

#include "frame/check.h"
#include "frame/error_estimate.h"

namespace strad {

// Points that have something in common.
struct CheckGroup {
  std::string name;         // of the body or material; of tenths empty
  double from = 0, to = 0;  // of tenths: W / (sr m^2) of the solution, or s
  ErrorEstimate error;
  double share = 0;  // of the whole squared error; noise can make it negative
};

struct CheckTable {
  std::string of;
  bool named = true;  // by names, not by ranges
  std::vector<CheckGroup> groups;
};

struct WorstPlace {
  Vec3 rest_point, normal;  // m; of the side, unit length
  double time = 0;          // s
  std::string object;
  PointError error;
};

struct CheckReport {
  ErrorEstimate total;
  std::vector<CheckTable> tables;  // by body, material, brightness, time
  std::vector<WorstPlace> worst;   // at most ten, by sure_error(), which is positive
};

// Bodies and materials of fewer than ten points are one group, "(others)". Brightness is the solution's,
// which has no noise to be sorted by.
CheckReport report_of(const Scene& scene, const std::vector<CheckSample>& samples, TimeRange range);

}  // namespace strad
