// The frames of a POV-Ray animation and their clocks.
#pragma once

#include "import/pov/language/run.h"

namespace strad {

struct PovAnimation {
  PovRun run;          // of all frames: size, declarations, folders; `run.clock` of a still
  bool moves = false;  // false: a still at run.clock
  int initial_frame = 1, final_frame = 1;
  double initial_clock = 0, final_clock = 1;
  bool cyclic = false;      // the frame after the last would be the first again
  int first = 1, last = 1;  // the frames that are taken
  double rate = 25;         // frames per second
};

// The constants in a frame, as POV-Ray 3.7 sets them: the clock runs evenly from the initial to the final
// frame.
PovRun run_of(const PovAnimation& animation, int frame);

}  // namespace strad
