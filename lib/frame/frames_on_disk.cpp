#include "frame/frames_on_disk.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "base/error.h"

namespace strad {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDigits = "0123456789";

// Adds the number for which the pattern gives `name`, trying every run of digits in it.
void add_number(const FilePattern& pattern, const std::string& name, std::vector<int>* numbers) {
  for (size_t begin = name.find_first_of(kDigits); begin != std::string::npos;) {
    const size_t end = std::min(name.find_first_not_of(kDigits, begin), name.size());
    int number = 0;
    const auto [stop, error] = std::from_chars(name.data() + begin, name.data() + end, number);
    if (error == std::errc{} && fs::path(pattern.name(number)).filename() == name)
      return numbers->push_back(number);
    begin = name.find_first_of(kDigits, end);
  }
}

// FIRST, FIRST:LAST or FIRST:LAST:STEP.
struct Range {
  int first = 0, last = 0, step = 1;
};

std::optional<Range> parse_range(std::string_view text) {
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
  const bool valid = at == end && range.first >= 0 && range.last >= range.first && range.step >= 1;
  return valid ? std::optional(range) : std::nullopt;
}

}  // namespace

std::vector<int> parse_frame_numbers(const std::string& option, const std::string& text) {
  std::vector<int> numbers;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    const std::optional<Range> range = parse_range(part);
    if (!range)
      throw BadInput(option + ": found '" + part + "', expected FIRST, FIRST:LAST or FIRST:LAST:STEP");
    for (int64_t number = range->first; number <= range->last; number += range->step)
      numbers.push_back(static_cast<int>(number));
    begin = end + 1;
  }
  return numbers;
}

std::vector<int> frames_on_disk(const FilePattern& pattern) {
  fs::path folder = fs::path(pattern.name(0)).parent_path();
  if (folder != fs::path(pattern.name(1)).parent_path())
    throw BadInput(pattern.name(0) + ": expected the number in the file's name, not in a folder's");
  if (folder.empty()) folder = ".";
  std::error_code error;
  std::vector<int> numbers;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    add_number(pattern, entry.path().filename().string(), &numbers);
  if (error) throw IoError(folder.string() + ": " + error.message());
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

}  // namespace strad
