#include "frame/frames_on_disk.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

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

}  // namespace

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
