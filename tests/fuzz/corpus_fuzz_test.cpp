// What fuzzers have tried and found (tests/fuzz/corpus, `make fuzz`) is accepted or refused, none does
// anything else.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "targets.h"

namespace strad {
namespace {

namespace fs = std::filesystem;

TEST(CorpusFuzz, EveryInputIsAcceptedOrRefused) {
  for (const FuzzTarget& target : fuzz_targets()) {
    const fs::path folder = fs::path(STRAD_SOURCE_DIR) / "tests/fuzz/corpus" / target.name;
    size_t count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      std::ifstream file(entry.path(), std::ios::binary);
      const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
      SCOPED_TRACE(entry.path());
      target.run({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()});
      ++count;
    }
    EXPECT_GT(count, 0u) << folder;
  }
}

}  // namespace
}  // namespace strad
