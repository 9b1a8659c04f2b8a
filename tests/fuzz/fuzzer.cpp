// A fuzzer of one target (libFuzzer, of clang): STRAD_FUZZ_TARGET is its name.
#include <cstdlib>

#include "targets.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static const auto run = [] {
    for (const strad::FuzzTarget& target : strad::fuzz_targets())
      if (target.name == STRAD_FUZZ_TARGET) return target.run;
    std::abort();
  }();
  run({data, size});
  return 0;
}
