// Mean direct irradiance of the leaves of the hierarchy.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/direct/direct_phase.h"
#include "solve/links/leaves.h"
#include "time/field.h"

namespace strad {

// Mean direct irradiance, W / m^2, of the leaves that are not uniform faces. REQUIRES: the surpluses were not
// yet taken from `phase`, since that frees the values at the vertices.
FunctionBlock direct_of_divided_leaves(const Workspace& work, const DirectPhase& phase);

// Mean direct irradiance of all leaves: from such a block, and for uniform faces, of which there may be a
// million, from the rows of their vertices.
class DirectOfLeaves {
 public:
  // `surpluses`: of direct light, complete. Keeps the references in `work`, and `surpluses`.
  DirectOfLeaves(const Workspace& work, FunctionBlock divided, const Field& surpluses)
      : work_(work), divided_(std::move(divided)), surpluses_(surpluses) {}

  // At the time samples of `count` cells from `first` on, W / m^2.
  std::vector<Rgb> irradiance(uint32_t leaf, uint32_t first, uint32_t count) const;
  // The same as the radiance that it is reflected with, W / (sr m^2).
  std::vector<Rgb> reflected(uint32_t leaf, uint32_t first, uint32_t count) const;

 private:
  const Workspace work_;
  FunctionBlock divided_;
  const Field& surpluses_;
};

}  // namespace strad
