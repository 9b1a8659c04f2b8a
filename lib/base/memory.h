// Gives freed memory back to the system.
#pragma once

#include <malloc.h>

namespace strad {

// For the end of a phase that frees millions of small blocks. The allocator would keep their pages, and the
// peak of memory would be the sum over all phases.
inline void release_freed_memory() { malloc_trim(0); }

}  // namespace strad
