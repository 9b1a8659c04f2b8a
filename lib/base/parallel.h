// Work shared among threads. Results must not depend on which thread does what.
#pragma once

#include <cstddef>
#include <functional>

namespace strad {

// Sets the number of threads that `parallel_for` uses; 0: all cores. Call once, at the start of a tool.
void set_thread_count(int threads);
int thread_count();

// Calls body(begin, end) over disjoint ranges of at most `grain` that cover [0, count).
void parallel_for(size_t count, size_t grain, const std::function<void(size_t, size_t)>& body);

}  // namespace strad
