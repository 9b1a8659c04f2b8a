// Lists of whole numbers on command lines: "1,5,10:20:2".
#pragma once

#include <string>
#include <vector>

namespace strad {

struct NumberBounds {
  int least = 0, most = 999'999'999;
  std::string what = "numbers from 0 on";  // for complaints: "frames 1 to 600"
};

// Single numbers, ranges FIRST:LAST and ranges with a step FIRST:LAST:STEP, with commas between, in the order
// given. Throws BadInput beginning with `option` unless all are within `bounds`, and for more than ten
// million.
std::vector<int> parse_number_list(const std::string& option, const std::string& text,
                                   const NumberBounds& bounds = {});

}  // namespace strad
