#include "import/pov/animation.h"

namespace strad {

PovRun run_of(const PovAnimation& animation, int frame) {
  PovRun run = animation.run;
  if (!animation.moves) return run;
  const int steps = animation.final_frame - animation.initial_frame + (animation.cyclic ? 1 : 0);
  const double span = animation.final_clock - animation.initial_clock;
  run.clock_on = true;
  run.clock_delta = steps > 0 ? span / steps : 0;
  run.clock = steps > 0 ? animation.initial_clock + span * (frame - animation.initial_frame) / steps
                        : animation.initial_clock;
  run.frame_number = frame;
  run.initial_frame = animation.initial_frame;
  run.final_frame = animation.initial_frame + steps;  // of a cyclic one, the frame after the last
  run.initial_clock = animation.initial_clock;
  run.final_clock = animation.final_clock;
  return run;
}

}  // namespace strad
