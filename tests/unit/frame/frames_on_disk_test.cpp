// Numbered files are found by their pattern.
#include "frame/frames_on_disk.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"

namespace strad {
namespace {

namespace fs = std::filesystem;

TEST(FramesOnDisk, AreFoundInOrder) {
  const fs::path folder = fs::temp_directory_path() / ("strad-frames-test." + std::to_string(getpid()));
  fs::create_directories(folder);
  for (const char* name : {"a.0010.exr", "a.0002.exr", "a.12345.exr", "a.3.exr", "a.exr", "a.0004.exr.tmp",
                           "b.0005.exr", "a.-001.exr"})
    std::ofstream(folder / name);
  EXPECT_EQ(frames_on_disk(FilePattern("--frames", (folder / "a.%04d.exr").string())),
            (std::vector<int>{2, 10, 12345}));
  EXPECT_EQ(frames_on_disk(FilePattern("--frames", folder.string() + "//a.%d.exr")),
            (std::vector<int>{3, 12345}));
  EXPECT_TRUE(frames_on_disk(FilePattern("--frames", (folder / "c.%d.exr").string())).empty());
  EXPECT_THROW(frames_on_disk(FilePattern("--frames", (folder / "%d/a.exr").string())), BadInput);
  EXPECT_THROW(frames_on_disk(FilePattern("--frames", (folder / "none/a.%d.exr").string())), IoError);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace strad
