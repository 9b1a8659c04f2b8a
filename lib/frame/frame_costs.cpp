#include "frame/frame_costs.h"

#include <algorithm>
#include <cstdio>

namespace strad {
namespace {

std::string seconds(double wall, double cpu) {
  char text[80];
  std::snprintf(text, sizeof text, "\"wall_seconds\": %.6g, \"cpu_seconds\": %.6g", wall, cpu);
  return text;
}

}  // namespace

std::string costs_as_json(const std::vector<FrameCost>& costs) {
  double wall = 0, cpu = 0;
  std::string frames;
  for (const FrameCost& cost : costs) {
    wall += cost.wall_seconds, cpu += cost.cpu_seconds;
    frames += std::string(frames.empty() ? "" : ",") + "\n    {\"frame\": " + std::to_string(cost.number) +
              ", \"kept\": " + (cost.kept ? "true" : "false") + ", " +
              seconds(cost.wall_seconds, cost.cpu_seconds) + "}";
  }
  const auto kept =
      std::count_if(costs.begin(), costs.end(), [](const FrameCost& cost) { return cost.kept; });
  return "{\n  \"frames\": " + std::to_string(costs.size()) + ",\n  \"kept\": " + std::to_string(kept) +
         ",\n  " + seconds(wall, cpu) + ",\n  \"each\": [" + frames + "\n  ]\n}\n";
}

}  // namespace strad
