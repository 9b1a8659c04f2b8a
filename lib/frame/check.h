// A solution measured: its light at points and instants, beside unbiased estimates of what is there.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/progress.h"
#include "frame/check_points.h"
#include "solution/solution_file.h"

namespace strad {

// Independent estimates at a point.
constexpr int kCheckEstimates = 16;

struct CheckOptions {
  uint32_t points = 1000;                    // at least 1
  uint32_t paths = 2048;                     // a point, at least 1; rounded up to whole estimates
  uint64_t seed = 0;                         // different seeds draw other points and paths
  ProbeDirect direct = ProbeDirect::kPoint;  // of the solution: as frames have it, or that of its mesh
  const Camera* camera = nullptr;            // points as its pixels see them; none: by area
  PictureSize size;                          // of the camera's picture
  TimeRange range;                           // of the instants, within the solution's
};

// Reflected radiance, W / (sr m^2): what emitters emit is exact and does not count.
struct CheckSample {
  CheckPoint point;
  Rgb solution;
  Rgb estimates[kCheckEstimates];  // unbiased and independent of each other
};

// In order of time. Of points by area those do not count where no light was found and none can be missed: on
// sides that the solution takes for dark, too, and in closed bodies or under them. The same for any number of
// threads. Throws BadInput when a chunk turns out to be damaged.
std::vector<CheckSample> check_solution(SolutionFile* file, const CheckOptions& options,
                                        const Progress& progress);

}  // namespace strad
