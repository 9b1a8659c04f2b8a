// Files and pipes give the same bytes.
#include "stream/source.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "base/error.h"
#include "test_folder.h"

namespace strad {
namespace {

using SourceTest = TestFolder;

TEST_F(SourceTest, AFileIsReadWhereItIsAskedFor) {
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

TEST_F(SourceTest, AFileThatIsCutMeanwhileIsRefused) {
  std::ofstream(path("a")) << std::string(3 << 20, 'x');
  Source source(path("a"));
  EXPECT_EQ(source.at(0, 3 << 20).size(), size_t{3 << 20});
  std::filesystem::resize_file(path("a"), 2 << 20);
  EXPECT_EQ(source.at(0, 2 << 20).size(), size_t{2 << 20});  // what is left
  try {
    source.at(0, 3 << 20);
    ADD_FAILURE() << "not refused";
  } catch (const BadInput& error) {
    EXPECT_EQ(std::string(error.what()),
              path("a") + ": byte 2097152: the stream ends, expected 1048576 bytes more");
  }
  std::filesystem::resize_file(path("a"), 0);
  EXPECT_THROW(source.at(0, 1), BadInput);
}

TEST_F(SourceTest, WhatCannotBeReadIsTold) {
  EXPECT_THROW(Source(path("absent")), IoError);
  EXPECT_THROW(Source(folder_.string()), BadInput);
}

}  // namespace
}  // namespace strad
