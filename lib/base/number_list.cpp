#include "base/number_list.h"

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/error.h"

namespace strad {
namespace {

constexpr size_t kMostNumbers = 10'000'000;

struct Range {
  int first = 0, last = 0, step = 1;
};

// FIRST, FIRST:LAST or FIRST:LAST:STEP.
std::optional<Range> range_in(std::string_view text) {
  int numbers[3] = {0, 0, 1};
  int count = 0;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (;;) {
    const auto [stop, error] = std::from_chars(at, end, numbers[count++]);
    if (error != std::errc{}) return {};
    at = stop;
    if (at == end || *at != ':' || count == 3) break;
    ++at;
  }
  const Range range{numbers[0], count == 1 ? numbers[0] : numbers[1], numbers[2]};
  const bool valid = at == end && range.last >= range.first && range.step >= 1;
  return valid ? std::optional(range) : std::nullopt;
}

}  // namespace

std::vector<int> parse_number_list(const std::string& option, const std::string& text,
                                   const NumberBounds& bounds) {
  std::vector<int> numbers;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    const std::optional<Range> range = range_in(part);
    if (!range || range->first < bounds.least || range->last > bounds.most)
      throw BadInput(option + ": found '" + part + "', expected A, A:B or A:B:S with " + bounds.what);
    for (int64_t number = range->first; number <= range->last; number += range->step) {
      if (numbers.size() == kMostNumbers) throw BadInput(option + ": found more than ten million numbers");
      numbers.push_back(static_cast<int>(number));
    }
    begin = end + 1;
  }
  return numbers;
}

}  // namespace strad
