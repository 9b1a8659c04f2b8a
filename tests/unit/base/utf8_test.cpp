// Which bytes are UTF-8 (RFC 3629, section 4).
#include "base/utf8.h"

#include <gtest/gtest.h>

namespace strad {
namespace {

TEST(Utf8, EveryLengthIsTakenAtItsEnds) {
  // U+0, U+7F, U+80, U+7FF, U+800, U+D7FF, U+E000, U+FFFF, U+10000, U+10FFFF.
  for (const std::string& text : {std::string(1, '\0'), std::string("\x7f")})
    EXPECT_EQ(utf8_length(text), 1u);
  for (const char* text : {"\xc2\x80", "\xdf\xbf"}) EXPECT_EQ(utf8_length(text), 2u);
  for (const char* text : {"\xe0\xa0\x80", "\xed\x9f\xbf", "\xee\x80\x80", "\xef\xbf\xbf"})
    EXPECT_EQ(utf8_length(text), 3u);
  for (const char* text : {"\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf"}) EXPECT_EQ(utf8_length(text), 4u);
  EXPECT_EQ(utf8_length(""), 0u);
}

TEST(Utf8, WhatIsCutLongerThanNeededOrNoCharacterIsNone) {
  for (const char* text :
       {"\x80", "\xc3", "\xc0\x80", "\xc1\xbf", "\xe0\x9f\xbf", "\xe2\x82", "\xed\xa0\x80",
        "\xf0\x8f\xbf\xbf", "\xf0\x90\x80", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff"}) {
    EXPECT_EQ(utf8_length(text), 0u);
    EXPECT_FALSE(is_utf8(std::string("a") + text));
  }
  EXPECT_TRUE(is_utf8(""));
  EXPECT_TRUE(is_utf8("gr\xc3\xbcn \xe2\x82\xac"));
}

TEST(Utf8, Latin1AndBrokenTextBecomeUtf8) {
  EXPECT_EQ(utf8_from_latin1("gr\xfcn\x80"), "gr\xc3\xbcn\xc2\x80");
  EXPECT_EQ(repaired_utf8("a\xff\xc3\xbc\xc3"), "a\xef\xbf\xbd\xc3\xbc\xef\xbf\xbd");
}

}  // namespace
}  // namespace strad
