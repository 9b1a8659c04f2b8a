// Text files of other programs: what is accepted as text, and how numbers, words and lines are read.
#include "base/text.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"

namespace strad {
namespace {

// What read_text says of a file with these bytes, without the file's name; "" if it is taken.
std::string refusal_of(const std::string& bytes) {
  const std::string path = testing::TempDir() + "/text_test.txt";
  std::ofstream(path, std::ios::binary) << bytes;
  std::string said;
  try {
    read_text(path);
  } catch (const BadInput& error) {
    said = std::string(error.what()).substr(path.size());
  }
  std::filesystem::remove(path);
  return said;
}

TEST(Text, FilesThatAreNoTextAreRefused) {
  EXPECT_EQ(refusal_of("plain\n"), "");
  EXPECT_EQ(refusal_of("\xc3\xa9\n"), "");  // UTF-8
  EXPECT_EQ(refusal_of(""), ": is empty");
  EXPECT_EQ(refusal_of("\xff\xfe"
                       "a"),
            ": is UTF-16 text, expected ASCII or UTF-8");
  EXPECT_EQ(refusal_of(std::string("ab\0c", 4)), ": is not a text file: byte 0 at offset 2");
  EXPECT_EQ(refusal_of("\x7f"), ": is not a text file: byte 127 at offset 0");
  EXPECT_THROW(read_text(testing::TempDir()), BadInput);
  EXPECT_THROW(read_text(testing::TempDir() + "/no_such_file"), IoError);
}

TEST(Text, ByteOrderMarkIsTakenOff) {
  const std::string path = testing::TempDir() + "/text_bom.txt";
  std::ofstream(path, std::ios::binary) << "\xef\xbb\xbf"
                                           "v 1";
  EXPECT_EQ(read_text(path), "v 1");
  std::filesystem::remove(path);
}

TEST(Text, PathsAreRelativeToTheFileThatNamesThem) {
  EXPECT_EQ(path_beside("rooms/hall.obj", "hall.mtl"), "rooms/hall.mtl");
  EXPECT_EQ(path_beside("hall.obj", "hall.mtl"), "hall.mtl");
  EXPECT_EQ(path_beside("rooms/hall.obj", "/lib/hall.mtl"), "/lib/hall.mtl");
  EXPECT_EQ(path_beside("-", "hall.mtl"), "hall.mtl");
  EXPECT_EQ(text_name("-"), "standard input");
  EXPECT_EQ(text_name("hall.obj"), "hall.obj");
}

TEST(Text, MessagesNameFileAndLine) {
  try {
    fail_at("hall.obj", 7, "found nothing");
    FAIL() << "fail_at returned";
  } catch (const BadInput& error) {
    EXPECT_STREQ(error.what(), "hall.obj:7: found nothing");
  }
}

TEST(Text, QuotesHideControlCharactersAndCutLongText) {
  EXPECT_EQ(in_quotes("a\tb\x1b"), "\"a?b?\"");
  EXPECT_EQ(in_quotes("abcdef", 6), "\"abcdef\"");
  EXPECT_EQ(in_quotes("abcdefg", 6), "\"abcdef...\"");
  EXPECT_EQ(in_quotes("gr\xfcn"), "\"gr?n\"");
  EXPECT_EQ(in_quotes("gr\xc3\xbcn", 3), "\"gr...\"");  // no half characters
  EXPECT_EQ(in_quotes("gr\xc3\xbcn", 4), "\"gr\xc3\xbc...\"");
}

TEST(Text, NumbersAreDecimalAndWhole) {
  EXPECT_EQ(number_in("1.5"), 1.5);
  EXPECT_EQ(number_in("+1"), 1.0);
  EXPECT_EQ(number_in("-.5"), -0.5);
  EXPECT_EQ(number_in("2."), 2.0);
  EXPECT_EQ(number_in("1e-3"), 1e-3);
  EXPECT_EQ(number_in("1e-999"), 0.0);  // too small for a double
  for (const char* text : {"", "+", "-", "+-1", "nan", "inf", "-inf", "0x10", "0,5", "1e", "1 ", " 1", "1a",
                           "1e39", "1e999"})  // the last two are no floats
    EXPECT_FALSE(number_in(text)) << text;
  EXPECT_EQ(integer_in("-12"), -12);
  for (const char* text : {"", "1.0", "1x", "99999999999999999999"}) EXPECT_FALSE(integer_in(text)) << text;
}

TEST(Text, WordsAreTakenOffTheFront) {
  std::string_view rest = "  one\ttwo ";
  EXPECT_EQ(next_word(&rest), "one");
  EXPECT_EQ(next_word(&rest), "two");
  EXPECT_EQ(next_word(&rest), "");
  EXPECT_EQ(trimmed(" \ta b\t "), "a b");
  EXPECT_EQ(trimmed(" \t"), "");
  EXPECT_TRUE(is_one_of("two", {"one", "two"}));
  EXPECT_FALSE(is_one_of("tw", {"one", "two"}));
}

struct NumberedLine {
  std::string text;
  uint32_t number;
  bool operator==(const NumberedLine&) const = default;
};

std::vector<NumberedLine> lines_of(std::string_view text) {
  std::vector<NumberedLine> lines;
  LineReader reader(text);
  while (reader.next()) lines.push_back({std::string(reader.line()), reader.number()});
  return lines;
}

TEST(Text, LinesEndWithAnyOfTheThreeEnds) {
  EXPECT_EQ(lines_of("a\nb\r\n c\rd"), (std::vector<NumberedLine>{{"a", 1}, {"b", 2}, {"c", 3}, {"d", 4}}));
  EXPECT_EQ(lines_of("a\n\nb\n"), (std::vector<NumberedLine>{{"a", 1}, {"", 2}, {"b", 3}}));
  EXPECT_TRUE(lines_of("").empty());
}

TEST(Text, BackslashJoinsLinesButNotComments) {
  EXPECT_EQ(lines_of("f 1 \\\n 2\\\n3\nnext"), (std::vector<NumberedLine>{{"f 1  2 3", 1}, {"next", 4}}));
  EXPECT_EQ(lines_of("# c \\\nv"), (std::vector<NumberedLine>{{"# c \\", 1}, {"v", 2}}));
  EXPECT_EQ(lines_of("end \\"), (std::vector<NumberedLine>{{"end", 1}}));
}

}  // namespace
}  // namespace strad
