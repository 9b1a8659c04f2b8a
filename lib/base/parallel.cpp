#include "base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <memory>

namespace strad {
namespace {
std::unique_ptr<tbb::global_control> g_limit;
}

void set_thread_count(int threads) {
  g_limit.reset();
  if (threads > 0)
    g_limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, threads);
}

int thread_count() {
  return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

void parallel_for(size_t count, size_t grain, const std::function<void(size_t, size_t)>& body) {
  tbb::parallel_for(
      tbb::blocked_range<size_t>(0, count, grain ? grain : 1),
      [&](const tbb::blocked_range<size_t>& range) { body(range.begin(), range.end()); },
      tbb::simple_partitioner());
}

}  // namespace strad
