// Runs the tests of one source file, or all: an executable holds those of a folder.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace {

// What --gtest_filter takes for the tests that stand in `name`.cpp; empty when there are none.
std::string tests_of_file(const std::string& name) {
  std::string filter;
  const auto* const program = testing::UnitTest::GetInstance();
  for (int s = 0; s < program->total_test_suite_count(); ++s) {
    const testing::TestSuite* const suite = program->GetTestSuite(s);
    for (int t = 0; t < suite->total_test_count(); ++t) {
      const testing::TestInfo* const test = suite->GetTestInfo(t);
      if (std::string(test->file()).ends_with("/" + name + ".cpp"))
        filter += std::string(suite->name()) + "." + test->name() + ":";
    }
  }
  return filter;
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (argc == 1) return RUN_ALL_TESTS();
  const std::string filter = argc == 2 ? tests_of_file(argv[1]) : "";
  if (filter.empty()) {
    std::fprintf(stderr, "usage: %s [NAME], where NAME.cpp is a file with tests of this folder\n", argv[0]);
    return 2;
  }
  testing::GTEST_FLAG(filter) = filter;
  return RUN_ALL_TESTS();
}
