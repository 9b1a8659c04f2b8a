// Files and pipes give the same bytes; output files are complete or absent.
#include "stream/source.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "base/error.h"
#include "stream/output_file.h"

namespace strad {
namespace {

namespace fs = std::filesystem;

class Folder : public testing::Test {
 protected:
  void SetUp() override {
    char name[] = "/tmp/strad-test-XXXXXX";
    folder_ = mkdtemp(name);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  size_t entries() const { return static_cast<size_t>(std::distance(fs::directory_iterator(folder_), {})); }
  static std::string content(const std::string& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  fs::path folder_;
};

using SourceTest = Folder;
using OutputTest = Folder;

TEST_F(SourceTest, AFileIsMapped) {
  std::ofstream(path("a")) << "hello";
  Source source(path("a"));
  EXPECT_TRUE(source.seekable());
  EXPECT_EQ(source.size(), 5u);
  const ByteSpan bytes = source.at(1, 3);
  EXPECT_EQ(std::string(bytes.begin(), bytes.end()), "ell");
  EXPECT_TRUE(source.ends_at(5));
  EXPECT_FALSE(source.ends_at(4));
  EXPECT_THROW(source.at(4, 2), BadInput);
  EXPECT_THROW(source.at(UINT64_MAX, 2), BadInput);
}

TEST_F(SourceTest, APipeIsReadAsFarAsNeeded) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  const std::string big(3 << 20, 'x');
  std::thread feeder([&] { std::ofstream(path("pipe")) << big << "end"; });
  {
    Source source(path("pipe"));
    EXPECT_FALSE(source.seekable());
    const ByteSpan bytes = source.at(big.size(), 3);
    EXPECT_EQ(std::string(bytes.begin(), bytes.end()), "end");
    EXPECT_TRUE(source.ends_at(big.size() + 3));
    EXPECT_THROW(source.at(big.size(), 4), BadInput);
  }
  feeder.join();
}

TEST_F(SourceTest, WhatCannotBeReadIsTold) {
  EXPECT_THROW(Source(path("absent")), IoError);
  EXPECT_THROW(Source(folder_.string()), BadInput);
}

TEST_F(OutputTest, AFileAppearsWhole) {
  Output output(path("a"));
  output.write("hello");
  EXPECT_FALSE(fs::exists(path("a")));
  output.commit();
  EXPECT_EQ(content(path("a")), "hello");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputTest, AFailureLeavesWhatWasThere) {
  std::ofstream(path("a")) << "old";
  {
    Output output(path("a"));
    output.write("new");
  }
  EXPECT_EQ(content(path("a")), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputTest, TheTemporaryNameKeepsFolderAndExtension) {
  WholeFile file(path("room.0001.exr"));
  EXPECT_EQ(fs::path(file.temporary()).extension(), ".exr");
  EXPECT_EQ(fs::path(file.temporary()).parent_path(), fs::path(folder_));
}

TEST_F(OutputTest, ALinkStaysALink) {
  std::ofstream(path("target")) << "old";
  fs::create_symlink(path("target"), path("link"));
  Output output(path("link"));
  output.write("new");
  output.commit();
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(content(path("target")), "new");
}

TEST_F(OutputTest, WhatIsNoPlainFileIsWrittenInPlace) {
  Output output("/dev/null");
  output.write("gone");
  output.commit();
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(OutputTest, AnAbsentFolderIsTold) { EXPECT_THROW(Output(path("absent/a")), IoError); }

TEST_F(OutputTest, ASignalRemovesTheTemporaryFile) {
  EXPECT_EXIT(
      {
        Output output(path("a"));
        output.write("half");
        std::raise(SIGTERM);
      },
      testing::KilledBySignal(SIGTERM), "");
  EXPECT_EQ(entries(), 0u);
}

}  // namespace
}  // namespace strad
