#include "solve/links/link_table.h"

#include <algorithm>

namespace strad {

LinkTable make_link_table(const TimeGrid& grid, uint32_t node_count, const std::vector<Link>& links) {
  LinkTable table;
  std::vector<uint32_t> order(links.size());
  for (uint32_t i = 0; i < links.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](uint32_t a, uint32_t b) { return links[a].receiver < links[b].receiver; });
  size_t next = 0;
  const uint32_t all_cells = grid.cell_count();
  for (uint32_t p = 0; p < node_count; ++p) {
    for (; next < order.size() && links[order[next]].receiver == p; ++next) {
      const Link& link = links[order[next]];
      const float* k = link.estimate.kernel;
      if (!link.estimate.dynamic && link.interval.cell_count() == all_cells) {
        if (k[0] > 0) table.still.push_back({link.emitter, k[0]});
      } else if (k[0] != 0 || k[1] != 0 || k[2] != 0) {
        table.dynamic.push_back({link.emitter, link.interval, {k[0], k[1], k[2]}});
      }
    }
    table.first_still.push_back(static_cast<uint32_t>(table.still.size()));
    table.first_dynamic.push_back(static_cast<uint32_t>(table.dynamic.size()));
  }
  return table;
}

}  // namespace strad
