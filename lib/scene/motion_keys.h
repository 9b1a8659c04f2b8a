// The `key` lines of a motion file.
#pragma once

#include "scene/motion_words.h"
#include "scene/scene.h"

namespace strad {

// Whether a length differs from 1 by no more than rounding. Such quaternions and axes are taken as they are,
// so that what was normalized once and written with all digits is read back as it was.
inline bool is_unit_to_rounding(double length) { return std::abs(length - 1) <= 1e-15; }

// `value` in as few digits as read back to the same number.
std::string motion_number(double value);

// Each appends the key that the rest of the line describes. Fields that the line leaves out keep their value
// of the key before. Defaults for the first key: move 0 0 0, turn 0, up 0 1 0, fov 40; all other fields are
// required. Keys are in order of time, at most two at the same time.
void take_key(MotionWords& words, std::vector<BodyKey>& keys);
void take_key(MotionWords& words, std::vector<SpotKey>& keys);
void take_key(MotionWords& words, std::vector<GlowKey>& keys);
void take_key(MotionWords& words, std::vector<CameraKey>& keys);

}  // namespace strad
