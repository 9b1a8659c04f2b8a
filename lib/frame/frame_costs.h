// What frames of a sequence cost, as they are made.
#pragma once

#include <string>
#include <vector>

namespace strad {

struct FrameCost {
  int number = 0;
  bool kept = false;  // its file was there already, and whole
  double wall_seconds = 0, cpu_seconds = 0;
};

// A JSON object with the frames in order and the sums over them.
std::string costs_as_json(const std::vector<FrameCost>& costs);

}  // namespace strad
