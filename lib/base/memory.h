// Memory that was freed, given back to the system.
#pragma once

#include <malloc.h>

namespace strad {

// Called where a phase has freed millions of small blocks: the allocator would keep their pages, and the peak
// would be the sum of all phases.
inline void release_freed_memory() { malloc_trim(0); }

}  // namespace strad
