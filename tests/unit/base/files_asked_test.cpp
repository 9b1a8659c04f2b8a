// Files are asked about without failing, and read from whatever has an end.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "base/error.h"
#include "base/files.h"

namespace strad {
namespace {

namespace fs = std::filesystem;

class FilesAsked : public testing::Test {
 protected:
  void SetUp() override {
    char name[] = "/tmp/strad-test-XXXXXX";
    folder_ = mkdtemp(name);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  static std::string content(const std::string& path) {
    std::string all;
    read_blocks(path, "a file", [&](std::string_view block) { all += block; });
    return all;
  }
  fs::path folder_;
};

TEST_F(FilesAsked, NamesThatNoFileCanHaveAreNotThere) {
  std::ofstream(path("a")) << "a";
  const std::string too_long(300, 'x');  // more than the 255 bytes of a name
  EXPECT_TRUE(file_exists(path("a")));
  EXPECT_TRUE(is_plain_file(path("a")));
  for (const std::string& name : {path(too_long), path("a/b"), path("none"), std::string()}) {
    EXPECT_FALSE(file_exists(name)) << name;
    EXPECT_FALSE(is_plain_file(name)) << name;
  }
  EXPECT_TRUE(file_exists(folder_.string()));
  EXPECT_FALSE(is_plain_file(folder_.string()));
}

TEST_F(FilesAsked, BlocksAreTheWholeFile) {
  const std::string big(200'000, 'x');  // more than three blocks
  std::ofstream(path("a")) << big << "end";
  EXPECT_EQ(content(path("a")), big + "end");
  EXPECT_THROW(content(path("none")), IoError);
  EXPECT_THROW(content(folder_.string()), BadInput);
}

// The writer is silent for a while, as a program that computes: it is waited for.
TEST_F(FilesAsked, APipeIsReadToTheEndOfItsWriter) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  std::thread writer([&] {
    const int pipe = ::open(path("pipe").c_str(), O_WRONLY);
    for (int i = 0; i < 3; ++i) {
      ::usleep(50'000);
      ASSERT_EQ(::write(pipe, "abc", 3), 3);
    }
    ::close(pipe);
  });
  EXPECT_EQ(content(path("pipe")), "abcabcabc");
  writer.join();
}

TEST_F(FilesAsked, WhatHasNoEndCanBeEnded) {
  EXPECT_THROW(read_blocks("/dev/zero", "a file", [](std::string_view) { throw BadInput("enough"); }),
               BadInput);
}

}  // namespace
}  // namespace strad
