#include "import/report.h"

#include <algorithm>

#include "base/text.h"

namespace strad {

void ImportReport::add(const std::string& what, const std::string& file, uint32_t line) {
  for (Entry& entry : entries_) {
    if (entry.what == what) {
      ++entry.count;
      if (entry.file == file) entry.line = std::min(entry.line, line);
      return;
    }
  }
  entries_.push_back({what, file, line, 1});
}

std::vector<std::string> ImportReport::lines() const {
  std::vector<std::string> lines;
  for (const Entry& entry : entries_) {
    const std::string count = entry.count > 1 ? " (" + std::to_string(entry.count) + " in all)" : "";
    const std::string line = entry.line > 0 ? ":" + std::to_string(entry.line) : "";
    lines.push_back(entry.file + line + ": " + entry.what + count);
  }
  return lines;
}

std::string ImportReport::first_left_out() const {
  std::string looks_only;  // "is left out": what is never taken
  for (const std::string& line : lines()) {
    if (line.find(" left out") == line.npos) continue;
    if (line.find(" is left out") == line.npos) return line;
    if (looks_only.empty()) looks_only = line;
  }
  return looks_only;
}

void refuse_missing(const std::string& what, const std::string& file, uint32_t line,
                    const SkipOptions& options, ImportReport* report) {
  if (!options.skip_missing) fail_at(file, line, what);
  report->add(what + ": left out", file, line);
}

}  // namespace strad
