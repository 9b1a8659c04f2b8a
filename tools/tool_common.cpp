// Options that tools have in common.
#include "base/parallel.h"
#include "tool_options.h"

namespace strad {
namespace {

constexpr int kMostJobs = 1024;

}  // namespace

void Options::output(const std::string& help) {
  path("-o,--output", "FILE", &common_->output, help);
  for (const char* name : {"-o", "--output"}) unrecorded(name, true);
}

void Options::jobs() {
  integer("-j,--jobs", "N", &common_->jobs,
          "threads to use; the result does not depend on it (default: all cores)");
  for (const char* name : {"-j", "--jobs"}) unrecorded(name, true);
}

void Options::apply_common() {
  const int jobs = common_->jobs;
  if (jobs < 0 || jobs > kMostJobs)
    fail_option("-j,--jobs", std::to_string(jobs), "0.." + std::to_string(kMostJobs));
  if (jobs > 0) set_thread_count(jobs);
}

}  // namespace strad
