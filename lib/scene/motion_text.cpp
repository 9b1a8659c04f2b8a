// The motion language, compiled onto a scene: names become indices.
#include "scene/motion_text.h"

#include <fnmatch.h>

#include <algorithm>
#include <numeric>

#include "base/error.h"
#include "base/likeness.h"
#include "base/text.h"
#include "scene/motion_blocks.h"
#include "scene/motion_keys.h"
#include "scene/motion_words.h"

namespace strad {
namespace {

// Names listed in a message before it says "...".
constexpr size_t kNamesShown = 5;

template <class Named>
std::string names_of(const std::vector<Named>& things) {
  std::string list;
  for (size_t i = 0; i < std::min(things.size(), kNamesShown); ++i) list += (i ? ", " : "") + things[i].name;
  return list + (things.size() > kNamesShown ? ", ..." : "");
}

template <class Named>
uint32_t find_named(const std::vector<Named>& things, const std::string& name) {
  const auto at = std::find_if(things.begin(), things.end(), [&](const Named& t) { return t.name == name; });
  return at == things.end() ? kNone : static_cast<uint32_t>(at - things.begin());
}

// Replaces the item of that name, or appends it if there is none. Returns its index.
template <class Named>
uint32_t put_named(std::vector<Named>& things, const Named& thing) {
  const uint32_t at = find_named(things, thing.name);
  if (at == kNone) {
    things.push_back(thing);
    return static_cast<uint32_t>(things.size() - 1);
  }
  things[at] = thing;
  return at;
}

// Index of the body that `on` names; the world if it is empty.
uint32_t body_named(const MotionName& on, const std::string& file, const Scene& scene) {
  if (on.line == 0) return 0;
  const uint32_t body = find_named(scene.bodies, on.name);
  if (body == kNone)
    fail_at(file, on.line, in_quotes(on.name), "the name of a body (" + names_of(scene.bodies) + ")");
  return body;
}

std::string like_object(const std::string& name, const Scene& scene) {
  std::vector<std::string> names;
  for (const Object& object : scene.objects) names.push_back(object.name);
  return did_you_mean(name, names);
}

void claim_part(const MotionName& part, uint32_t body, const std::string& file, Scene& scene) {
  bool matched = false;
  for (Object& object : scene.objects) {
    if (fnmatch(part.name.c_str(), object.name.c_str(), 0) != 0) continue;
    matched = true;
    if (object.body != 0 && object.body != body)
      fail_at(file, part.line,
              "object " + in_quotes(object.name) + " of body " + in_quotes(scene.bodies[object.body].name),
              "an object of no other body");
    object.body = body;
  }
  if (!matched)
    fail_at(file, part.line, "no object named " + in_quotes(part.name),
            "a name or pattern of objects (" + names_of(scene.objects) + ")" + like_object(part.name, scene));
}

void refuse_cycle(uint32_t body, const MotionName& on, const std::string& file, const Scene& scene) {
  std::string path = scene.bodies[body].name;
  uint32_t above = scene.bodies[body].parent;
  // After as many steps as there are bodies the walk is in a cycle further up, which does not contain this
  // body. It is reported for the bodies in it.
  for (size_t step = 0; above != 0 && step < scene.bodies.size(); ++step) {
    path += " on " + scene.bodies[above].name;
    if (above == body)
      fail_at(file, on.line, "a cycle (" + path + ")", "a parent that does not ride on this body");
    above = scene.bodies[above].parent;
  }
}

uint32_t depth_of(uint32_t body, const Scene& scene) {
  uint32_t depth = 0;
  for (; body != 0; body = scene.bodies[body].parent) ++depth;
  return depth;
}

// Puts parents before their children, otherwise keeping the order. REQUIRES: no cycles.
void sort_bodies(Scene& scene) {
  std::vector<uint32_t> order(scene.bodies.size()), depth(scene.bodies.size());
  std::iota(order.begin(), order.end(), 0u);
  for (const uint32_t body : order) depth[body] = depth_of(body, scene);
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return depth[a] < depth[b]; });
  std::vector<uint32_t> place(order.size());
  for (uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  std::vector<Body> sorted;
  for (const uint32_t body : order) {
    Body& moved = sorted.emplace_back(std::move(scene.bodies[body]));
    moved.parent = place[moved.parent];
  }
  scene.bodies = std::move(sorted);
  for (Object& object : scene.objects) object.body = place[object.body];
  for (Spot& spot : scene.spots) spot.body = place[spot.body];
}

void apply_bodies(const std::vector<BodyBlock>& blocks, const std::string& file, Scene& scene) {
  std::vector<uint32_t> bodies;
  for (const BodyBlock& block : blocks) {
    bodies.push_back(put_named(scene.bodies, block.body));
    for (Object& object : scene.objects)
      if (object.body == bodies.back()) object.body = 0;
  }
  for (size_t i = 0; i < blocks.size(); ++i) {
    scene.bodies[bodies[i]].parent = body_named(blocks[i].on, file, scene);
    for (const MotionName& part : blocks[i].parts) claim_part(part, bodies[i], file, scene);
  }
  for (size_t i = 0; i < blocks.size(); ++i) refuse_cycle(bodies[i], blocks[i].on, file, scene);
  sort_bodies(scene);
}

void apply_spots(const std::vector<SpotBlock>& blocks, const std::string& file, Scene& scene) {
  for (const SpotBlock& block : blocks) {
    Spot spot = block.spot;
    spot.body = body_named(block.on, file, scene);
    put_named(scene.spots, spot);
  }
}

void apply_glows(const std::vector<GlowBlock>& blocks, const std::string& file, Scene& scene) {
  for (const GlowBlock& block : blocks) {
    const uint32_t material = find_named(scene.materials, block.material.name);
    if (material == kNone)
      fail_at(file, block.material.line, in_quotes(block.material.name),
              "the name of a material (" + names_of(scene.materials) + ")");
    std::erase_if(scene.glows, [&](const Glow& glow) { return glow.material == material; });
    scene.glows.push_back({material, block.keys});
  }
  std::sort(scene.glows.begin(), scene.glows.end(),
            [](const Glow& a, const Glow& b) { return a.material < b.material; });
}

}  // namespace

void apply_motion(std::string_view text, const std::string& file, Scene& scene) {
  const MotionBlocks blocks = parse_motion(text, file);
  if (blocks.interval) {
    scene.start = blocks.interval->start;
    scene.end = blocks.interval->end;
  }
  if (blocks.rate) scene.rate = *blocks.rate;
  apply_bodies(blocks.bodies, file, scene);
  apply_spots(blocks.spots, file, scene);
  apply_glows(blocks.glows, file, scene);
  for (const Camera& camera : blocks.cameras) put_named(scene.cameras, camera);
  try {
    validate(scene);
  } catch (const BadInput& error) {
    // Faults of the scene as a whole, such as too many frames.
    throw BadInput(file + ": " + error.what());
  }
}

Camera parse_camera(const std::string& name, const std::string& text) {
  std::vector<MotionLine> lines = motion_lines("0 " + text, name);
  if (lines.size() != 1) throw BadInput(name + ": found several lines, expected one");
  lines[0].number = 0;
  Camera camera{name, {}};
  MotionWords words(name, lines[0]);
  take_key(words, camera.keys);
  words.expect_end();
  return camera;
}

}  // namespace strad
