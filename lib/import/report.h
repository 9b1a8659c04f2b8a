// What an import leaves out or changes, and what it refuses.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace strad {

struct SkipOptions {
  bool skip_missing = false;  // leave out files and materials that are not there, in place of refusing
  bool skip_unknown = false;  // leave out statements that have no meaning here, in place of refusing
};

// What was left out or changed. Each kind is one line: its first place in the file, and how often it occurs.
class ImportReport {
 public:
  void add(const std::string& what, const std::string& file, uint32_t line);
  std::vector<std::string> lines() const;

 private:
  struct Entry {
    std::string what, file;
    uint32_t line = 0, count = 0;
  };
  std::vector<Entry> entries_;
};

// `what` says that a file or a material is missing. Throws BadInput, or reports that it is left out, as told
// by options.skip_missing.
void refuse_missing(const std::string& what, const std::string& file, uint32_t line,
                    const SkipOptions& options, ImportReport* report);

}  // namespace strad
