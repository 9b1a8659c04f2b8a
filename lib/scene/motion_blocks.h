// The statements of a motion file, each checked by itself. Names are not yet looked up in a scene.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace strad {

// A name and the line it stands on.
struct MotionName {
  std::string name;
  int line = 0;
};

struct BodyBlock {
  Body body;      // without parent
  MotionName on;  // parent; empty: the world
  std::vector<MotionName> parts;
};

struct SpotBlock {
  Spot spot;  // without body
  MotionName on;
};

struct GlowBlock {
  MotionName material;
  std::vector<GlowKey> keys;
};

struct MotionInterval {
  double start = 0, end = 0;  // s
};

// Each name occurs once per kind. If a file repeats one, the later block replaces the earlier, at its place.
struct MotionBlocks {
  std::optional<MotionInterval> interval;
  std::optional<double> rate;
  std::vector<BodyBlock> bodies;
  std::vector<SpotBlock> spots;
  std::vector<GlowBlock> glows;
  std::vector<Camera> cameras;
};

// Throws BadInput. `file` is the name used in messages.
MotionBlocks parse_motion(std::string_view text, const std::string& file);

}  // namespace strad
