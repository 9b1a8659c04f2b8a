// File names with a frame number in them.
#include "base/file_pattern.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace strad {
namespace {

std::string named(const std::string& pattern, int number) { return FilePattern("-o", pattern).name(number); }

TEST(FilePattern, WritesLikePrintf) {
  EXPECT_EQ(named("room.%04d.exr", 7), "room.0007.exr");
  EXPECT_EQ(named("room.%d", 12345), "room.12345");
  EXPECT_EQ(named("%3d.png", 7), "  7.png");
  EXPECT_EQ(named("%02d.png", 123), "123.png");
  EXPECT_EQ(named("%0d.png", 5), "5.png");
  EXPECT_EQ(named("100%%/%d%%.png", 5), "100%/5%.png");
  EXPECT_EQ(named("plain.png", 5), "plain.png");
}

TEST(FilePattern, KnowsWhetherItIsNumbered) {
  EXPECT_TRUE(FilePattern("-o", "a%d").numbered());
  EXPECT_FALSE(FilePattern("-o", "a%%d").numbered());
}

TEST(FilePattern, AnythingElseIsRefused) {
  for (const char* pattern : {"", "%", "a%", "%s", "%x", "%4", "%-4d", "%+d", "% d", "%4.2d", "%ld", "%d%d",
                              "%d.%s", "%*d", "%1$d", "%10d", "%n"}) {
    EXPECT_THROW(FilePattern("-o", pattern), BadInput) << pattern;
  }
}

}  // namespace
}  // namespace strad
