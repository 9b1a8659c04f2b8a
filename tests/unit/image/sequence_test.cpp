// Names of numbered files, and finding them again.
#include "image/sequence.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"

namespace strad {
namespace {

namespace fs = std::filesystem;

TEST(Sequence, NumbersAreWrittenAsPrintfDoes) {
  EXPECT_EQ(frame_path("a.%04d.exr", 7), "a.0007.exr");
  EXPECT_EQ(frame_path("a.%04d.exr", 12345), "a.12345.exr");
  EXPECT_EQ(frame_path("a%d", 7), "a7");
  EXPECT_EQ(frame_path("a%3d", 7), "a  7");
  EXPECT_EQ(frame_path("100%%/%02d.png", 7), "100%/07.png");
}

TEST(Sequence, OtherPatternsAreRefused) {
  for (const char* pattern :
       {"a.exr", "%s.exr", "%04x", "%", "%04", "%d.%d", "%-4d", "%99999999999999999999d", "100%%"})
    EXPECT_THROW(frame_path(pattern, 1), BadInput) << pattern;
}

TEST(Sequence, FilesThatFitAreFoundInOrder) {
  const fs::path folder = fs::temp_directory_path() / ("strad-sequence-test." + std::to_string(getpid()));
  fs::create_directories(folder);
  for (const char* name : {"a.0010.exr", "a.0002.exr", "a.12345.exr", "a.3.exr", "a.exr", "a.0004.exr.tmp",
                           "b.0005.exr", "a.-001.exr"})
    std::ofstream(folder / name);
  EXPECT_EQ(frames_on_disk((folder / "a.%04d.exr").string()), (std::vector<int>{2, 10, 12345}));
  EXPECT_EQ(frames_on_disk(folder.string() + "//a.%d.exr"), (std::vector<int>{3, 12345}));
  EXPECT_TRUE(frames_on_disk((folder / "c.%d.exr").string()).empty());
  EXPECT_THROW(frames_on_disk((folder / "%d/a.exr").string()), BadInput);
  EXPECT_THROW(frames_on_disk((folder / "none/a.%d.exr").string()), IoError);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace strad
