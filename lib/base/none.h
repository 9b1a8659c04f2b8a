// The index that means "none".
#pragma once

#include <cstdint>

namespace strad {

constexpr uint32_t kNone = 0xffffffffu;

}  // namespace strad
