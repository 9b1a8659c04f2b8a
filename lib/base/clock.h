// Clocks for reports of what work costs; nothing computed may depend on them.
#pragma once

#include <chrono>
#include <ctime>

namespace strad {

// s, of all threads of this process.
inline double cpu_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// s, from an arbitrary start; it never goes back.
inline double wall_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace strad
