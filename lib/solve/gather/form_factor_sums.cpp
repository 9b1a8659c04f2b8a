#include "solve/gather/form_factor_sums.h"

#include <algorithm>
#include <numeric>

#include "base/parallel.h"
#include "solve/gather/final_gather.h"

namespace strad {

std::vector<float> form_factor_sums_by_rays(const Workspace& work, uint64_t* rays) {
  const std::vector<Node>& nodes = work.tree.nodes();
  const FunctionBlock no_radiance;
  const FinalGather gather(work.tree, work.tracer, work.grid, work.swept, no_radiance, kLeafRays);
  std::vector<float> form_factor_sums(nodes.size(), 1.0f);
  std::vector<uint64_t> counts(nodes.size(), 0);
  parallel_for(nodes.size(), 16, [&](size_t begin, size_t end) {
    for (size_t n = begin; n < end; ++n) {
      if (!nodes[n].is_leaf()) continue;
      const FinalGather::View view = gather.view_of(static_cast<uint32_t>(n), &counts[n]);
      form_factor_sums[n] = view.lit / std::max(1 - view.unlit, kLeastUnblocked);
    }
  });
  *rays += std::accumulate(counts.begin(), counts.end(), uint64_t{0});
  return form_factor_sums;
}

}  // namespace strad
