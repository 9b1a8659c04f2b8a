// Lists of numbers are read in their order, or refused.
#include "base/number_list.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace strad {
namespace {

TEST(NumberList, IsReadInOrder) {
  EXPECT_EQ(parse_number_list("-f", "61"), (std::vector<int>{61}));
  EXPECT_EQ(parse_number_list("-f", "1:10:4,298:300,7"), (std::vector<int>{1, 5, 9, 298, 299, 300, 7}));
  for (const char* text :
       {"", "a", "1:", ":2", "2:1", "1:5:0", "1:5:-1", "-1", "1:2:3:4", "1,,2", "1,", "1.5", "99999999999"})
    EXPECT_THROW(parse_number_list("-f", text), BadInput) << text;
}

TEST(NumberList, KeepsToItsBounds) {
  const NumberBounds bounds{3, 8, "frames 3 to 8"};
  EXPECT_EQ(parse_number_list("-f", "3:8:5", bounds), (std::vector<int>{3, 8}));
  EXPECT_THROW(parse_number_list("-f", "2:4", bounds), BadInput);
  EXPECT_THROW(parse_number_list("-f", "4,9", bounds), BadInput);
  // Eleven million numbers, which would take memory for nothing.
  EXPECT_THROW(parse_number_list("-f", "1:11000000"), BadInput);
}

}  // namespace
}  // namespace strad
