// The only user of polyclipping (Vatti 1992).
#include "import/pov/ring_sets.h"

#include <clipper.hpp>

namespace strad {
namespace {

ClipperLib::Paths paths_of(const RingSet& rings) {
  ClipperLib::Paths paths(rings.size());
  for (size_t i = 0; i < rings.size(); ++i)
    for (const RingPoint& point : rings[i]) paths[i].emplace_back(point[0], point[1]);
  return paths;
}

}  // namespace

RingSet combined(RingOperation operation, const RingSet& a, const RingSet& b) {
  ClipperLib::Clipper clipper(ClipperLib::ioStrictlySimple);
  clipper.AddPaths(paths_of(a), ClipperLib::ptSubject, true);
  clipper.AddPaths(paths_of(b), ClipperLib::ptClip, true);
  const auto type = operation == RingOperation::kBoth     ? ClipperLib::ctIntersection
                    : operation == RingOperation::kEither ? ClipperLib::ctUnion
                                                          : ClipperLib::ctDifference;
  ClipperLib::Paths found;
  clipper.Execute(type, found, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  RingSet rings(found.size());
  for (size_t i = 0; i < found.size(); ++i)
    for (const ClipperLib::IntPoint& point : found[i])
      rings[i].push_back({static_cast<int64_t>(point.X), static_cast<int64_t>(point.Y)});
  return rings;
}

double doubled_area(const RingSet& rings) {
  double sum = 0;
  for (const Ring& ring : rings) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const RingPoint &p = ring[i], &q = ring[(i + 1) % ring.size()], &o = ring[0];
      sum += static_cast<double>(p[0] - o[0]) * static_cast<double>(q[1] - o[1]) -
             static_cast<double>(q[0] - o[0]) * static_cast<double>(p[1] - o[1]);
    }
  }
  return sum;
}

}  // namespace strad
