// What is fuzzed: readers of everything that comes from outside. Each takes any bytes and returns, or has a
// fault.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace strad {

struct FuzzTarget {
  std::string name;  // of its folder in tests/fuzz/corpus
  void (*run)(std::span<const uint8_t> input);
};

const std::vector<FuzzTarget>& fuzz_targets();

}  // namespace strad
