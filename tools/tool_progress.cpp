#include "tool_progress.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>
#include <mutex>

#include "tool.h"

namespace strad {
namespace {

using Clock = std::chrono::steady_clock;

// Drawn after a second and then ten times a second; wiped at the end.
class Bar {
 public:
  ~Bar() {
    if (drawn_) std::fputs("\r\33[K", stderr);
  }

  void draw(double fraction, const std::string& what) {
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    drawn_ = true;
    constexpr int kWidth = 40;
    const int filled = static_cast<int>(kWidth * std::min(std::max(fraction, 0.0), 1.0));
    const std::string bar = std::string(static_cast<size_t>(filled), '#') +
                            std::string(static_cast<size_t>(kWidth - filled), '.');
    std::fprintf(stderr, "\r\33[K[%s] %3d %% %s", bar.c_str(), static_cast<int>(100 * fraction),
                 what.c_str());
    std::fflush(stderr);
  }

 private:
  std::mutex mutex_;
  Clock::time_point next_ = Clock::now() + std::chrono::seconds(1);
  bool drawn_ = false;
};

// Without -v and without a terminal, in the log of a job, the steps that took as long as this are told.
constexpr double kLongStep = 5;  // s

// A line for each step that has ended and took at least so many seconds.
class StepLines {
 public:
  StepLines(const Common& common, double least) : common_(common), least_(least) {}
  ~StepLines() {
    if (std::uncaught_exceptions() == 0) end_step();
  }
  StepLines(const StepLines&) = delete;
  StepLines& operator=(const StepLines&) = delete;

  void tell(const std::string& step) {
    const std::lock_guard lock(mutex_);
    if (step == step_) return;
    end_step();
    step_ = step;
    begin_ = Clock::now();
  }

 private:
  void end_step() const {
    if (step_.empty()) return;
    const double took = std::chrono::duration<double>(Clock::now() - begin_).count();
    if (took < least_) return;
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, ": %.2f s", took);
    note(common_, step_ + seconds);
  }

  const Common common_;
  const double least_;
  std::mutex mutex_;
  std::string step_;
  Clock::time_point begin_;
};

}  // namespace

Progress progress_on_stderr(const Common& common) {
  if (common.quiet) return {};
  if (common.verbose || ::isatty(STDERR_FILENO) != 1) {
    const double least = common.verbose ? 0 : kLongStep;
    return [lines = std::make_shared<StepLines>(common, least)](double, const std::string& step) {
      lines->tell(step);
    };
  }
  return [bar = std::make_shared<Bar>()](double fraction, const std::string& step) {
    bar->draw(fraction, step);
  };
}

}  // namespace strad
