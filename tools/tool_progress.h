// Progress on standard error: a bar on a terminal, or with -v a line per step.
#pragma once

#include "base/progress.h"
#include "tool_options.h"

namespace strad {

// Nothing with -q. With -v a line "TEXT: SECONDS s" when a step ends, that is when the text changes or the
// last copy is destroyed. Else a bar for work longer than a second on a terminal, and where there is none a
// line for each step that took long. Copies share one state; thread-safe.
//   solve(scene, options, &stats, progress_on_stderr(common));
Progress progress_on_stderr(const Common& common);

}  // namespace strad
