#include "solve/stats.h"

namespace strad {

PhaseStats operator+(PhaseStats a, const PhaseStats& b) {
  a.cpu_seconds += b.cpu_seconds;
  a.wall_seconds += b.wall_seconds;
  a.links += b.links;
  a.links_refined_in_time += b.links_refined_in_time;
  a.links_refined_in_space += b.links_refined_in_space;
  a.kernel_evaluations += b.kernel_evaluations;
  a.rays += b.rays;
  return a;
}

}  // namespace strad
