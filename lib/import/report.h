// What an import leaves out or changes, and what it refuses.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace strad {

struct SkipOptions {
  bool skip_missing = false;  // leave out files and materials that are not there, instead of refusing them
  bool skip_unknown = false;  // leave out statements that have no meaning here, instead of refusing them
};

// What was left out or changed. Each kind is one line: its first place in the file, and how often it occurs.
class ImportReport {
 public:
  // `line` 0: the whole file.
  void add(const std::string& what, const std::string& file, uint32_t line);
  std::vector<std::string> lines() const;
  // The first line of what was left out, at best of what was not supported; or "".
  std::string first_left_out() const;

 private:
  struct Entry {
    std::string what, file;
    uint32_t line = 0, count = 0;
  };
  std::vector<Entry> entries_;
};

// For a file or material that is missing, as `what` says. Throws BadInput, or with options.skip_missing
// reports that it is left out.
void refuse_missing(const std::string& what, const std::string& file, uint32_t line,
                    const SkipOptions& options, ImportReport* report);

}  // namespace strad
