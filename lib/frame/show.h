// Pictures of what a solution is made of, in place of light: the elements of its mesh, how much they err, how
// open surfaces are.
#pragma once

#include <cstdint>
#include <string>

#include "frame/camera.h"
#include "frame/surfaces.h"
#include "image/image.h"
#include "light/tracer.h"
#include "solution/solution.h"

namespace strad {

enum class ShowWhat : uint8_t { kElements, kError, kOpenness };

// elements, error or openness. REQUIRES: one of these.
inline ShowWhat show_named(const std::string& word) {
  if (word == "elements") return ShowWhat::kElements;
  return word == "error" ? ShowWhat::kError : ShowWhat::kOpenness;
}

struct ShowOptions {
  ShowWhat what = ShowWhat::kElements;
  uint32_t width = 640, height = 480;  // pixels
  double exposure = 0;                 // error and openness are scaled by 2^exposure
  double within = 0;  // m: how far openness looks; 0: a tenth of the diagonal of the scene at rest
  int samples = 16;   // points a pixel at which openness is looked for, >= 1
};

// Whether it shows a solution, not only the scene.
inline bool needs_solution(ShowWhat what) { return what != ShowWhat::kOpenness; }

class Show {
 public:
  explicit Show(const Scene& scene);  // keeps a reference

  // A picture in linear colours, the same for any number of threads. REQUIRES: `slab` holds `time`, unless
  // what is shown needs no solution.
  Image render(const Slab* slab, const Camera& camera, double time, const ShowOptions& options) const;

 private:
  const Scene& scene_;
  Tracer tracer_;
  Surfaces surfaces_;
};

}  // namespace strad
