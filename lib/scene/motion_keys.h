// The `key` lines of a motion file.
#pragma once

#include "scene/motion_words.h"
#include "scene/scene.h"

namespace strad {

inline double radians(double degrees) { return degrees * kDegree; }

// As short as it can be and still read back the same.
std::string motion_number(double value);

// Each appends the key that the rest of the line describes. What a line leaves out stays as in the key
// before; the first key has move 0 0 0, turn 0, up 0 1 0 and fov 40, and must name all else. Keys come in
// order of time, at most two at one time.
void take_key(MotionWords& words, std::vector<BodyKey>& keys);
void take_key(MotionWords& words, std::vector<SpotKey>& keys);
void take_key(MotionWords& words, std::vector<GlowKey>& keys);
void take_key(MotionWords& words, std::vector<CameraKey>& keys);

}  // namespace strad
