// The motion language, compiled onto a scene: names become indices.
#include "scene/motion_text.h"

#include <fnmatch.h>

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "base/error.h"
#include "base/likeness.h"
#include "base/text.h"
#include "scene/motion_blocks.h"
#include "scene/motion_keys.h"
#include "scene/motion_words.h"
#include "scene/name_index.h"

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

// Compiles blocks onto a scene.
class MotionCompiler {
 public:
  MotionCompiler(const std::string& file, Scene* scene)
      : file_(file), scene_(*scene), bodies_(index_of_names(&scene->bodies)) {}
  void apply_bodies(const std::vector<BodyBlock>& blocks);
  void apply_spots(const std::vector<SpotBlock>& blocks);
  void apply_glows(const std::vector<GlowBlock>& blocks);

 private:
  uint32_t body_named(const MotionName& on) const;
  void claim_part(const MotionName& part, uint32_t body);
  void claim(uint32_t object, const MotionName& part, uint32_t body);
  void refuse_cycle(uint32_t body, const MotionName& on) const;
  void sort_bodies();

  const std::string& file_;
  Scene& scene_;
  NameIndex<Body> bodies_;
  std::unordered_map<std::string, std::vector<uint32_t>> objects_;
};

// Index of the body that `on` names; the world if it is empty.
uint32_t MotionCompiler::body_named(const MotionName& on) const {
  if (on.line == 0) return 0;
  const uint32_t body = bodies_.find(on.name);
  if (body == kNone)
    fail_at(file_, on.line, in_quotes(on.name), "the name of a body (" + names_of(scene_.bodies) + ")");
  return body;
}

std::string like_object(const std::string& name, const Scene& scene) {
  std::vector<std::string> names;
  for (const Object& object : scene.objects) names.push_back(object.name);
  return did_you_mean(name, names);
}

void MotionCompiler::claim(uint32_t index, const MotionName& part, uint32_t body) {
  Object& object = scene_.objects[index];
  if (object.body != 0 && object.body != body)
    fail_at(file_, part.line,
            "object " + in_quotes(object.name) + " of body " + in_quotes(scene_.bodies[object.body].name),
            "an object of no other body");
  object.body = body;
}

// A name without the signs of shell patterns is looked up, for there may be many bodies.
void MotionCompiler::claim_part(const MotionName& part, uint32_t body) {
  bool matched = false;
  if (part.name.find_first_of("*?[\\") == part.name.npos) {
    const auto found = objects_.find(part.name);
    matched = found != objects_.end();
    if (matched)
      for (const uint32_t object : found->second) claim(object, part, body);
  } else {
    for (uint32_t i = 0; i < scene_.objects.size(); ++i) {
      if (fnmatch(part.name.c_str(), scene_.objects[i].name.c_str(), 0) != 0) continue;
      matched = true;
      claim(i, part, body);
    }
  }
  if (!matched)
    fail_at(
        file_, part.line, "no object named " + in_quotes(part.name),
        "a name or pattern of objects (" + names_of(scene_.objects) + ")" + like_object(part.name, scene_));
}

// REQUIRES: `body` is in a cycle.
void MotionCompiler::refuse_cycle(uint32_t body, const MotionName& on) const {
  std::string path = scene_.bodies[body].name;
  uint32_t above = body;
  do {
    above = scene_.bodies[above].parent;
    path += " on " + scene_.bodies[above].name;
  } while (above != body);
  fail_at(file_, on.line, "a cycle (" + path + ")", "a parent that does not ride on this body");
}

// How many parents each body has up to the world; kNone for bodies in a cycle and those that ride on them.
std::vector<uint32_t> depths_of(const std::vector<Body>& bodies) {
  std::vector<uint32_t> depth(bodies.size(), kNone), chain;
  std::vector<bool> seen(bodies.size());
  depth[0] = 0;
  for (uint32_t body = 0; body < bodies.size(); ++body) {
    chain.clear();
    uint32_t above = body;
    for (; !seen[above] && depth[above] == kNone; above = bodies[above].parent) {
      seen[above] = true;
      chain.push_back(above);
    }
    if (depth[above] == kNone) continue;  // a cycle
    uint32_t next = depth[above];
    for (auto link = chain.rbegin(); link != chain.rend(); ++link) depth[*link] = ++next;
  }
  return depth;
}

// Whether a walk up from `body` comes back to it.
bool is_in_cycle(uint32_t body, const std::vector<Body>& bodies) {
  uint32_t above = bodies[body].parent;
  for (size_t step = 0; above != body && step < bodies.size(); ++step) above = bodies[above].parent;
  return above == body;
}

// Puts parents before their children, otherwise keeping the order. REQUIRES: no cycles.
void MotionCompiler::sort_bodies() {
  const std::vector<uint32_t> depth = depths_of(scene_.bodies);
  std::vector<uint32_t> order(scene_.bodies.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return depth[a] < depth[b]; });
  std::vector<uint32_t> place(order.size());
  for (uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  std::vector<Body> sorted;
  for (const uint32_t body : order) {
    Body& moved = sorted.emplace_back(std::move(scene_.bodies[body]));
    moved.parent = place[moved.parent];
  }
  scene_.bodies = std::move(sorted);
  bodies_ = index_of_names(&scene_.bodies);
  for (Object& object : scene_.objects) object.body = place[object.body];
  for (Spot& spot : scene_.spots) spot.body = place[spot.body];
}

void MotionCompiler::apply_bodies(const std::vector<BodyBlock>& blocks) {
  for (uint32_t i = 0; i < scene_.objects.size(); ++i) objects_[scene_.objects[i].name].push_back(i);
  std::vector<uint32_t> bodies;
  for (const BodyBlock& block : blocks) bodies.push_back(bodies_.put(block.body));
  std::vector<bool> is_new(scene_.bodies.size());
  for (const uint32_t body : bodies) is_new[body] = true;
  for (Object& object : scene_.objects)
    if (is_new[object.body]) object.body = 0;
  for (size_t i = 0; i < blocks.size(); ++i) {
    scene_.bodies[bodies[i]].parent = body_named(blocks[i].on);
    for (const MotionName& part : blocks[i].parts) claim_part(part, bodies[i]);
  }
  const std::vector<uint32_t> depth = depths_of(scene_.bodies);
  for (size_t i = 0; i < blocks.size(); ++i)
    if (depth[bodies[i]] == kNone && is_in_cycle(bodies[i], scene_.bodies))
      refuse_cycle(bodies[i], blocks[i].on);
  sort_bodies();
}

void MotionCompiler::apply_spots(const std::vector<SpotBlock>& blocks) {
  NameIndex<Spot> spots = index_of_names(&scene_.spots);
  for (const SpotBlock& block : blocks) {
    Spot spot = block.spot;
    spot.body = body_named(block.on);
    spots.put(spot);
  }
}

void MotionCompiler::apply_glows(const std::vector<GlowBlock>& blocks) {
  const NameIndex<Material> materials = index_of_names(&scene_.materials);
  for (const GlowBlock& block : blocks) {
    const uint32_t material = materials.find(block.material.name);
    if (material == kNone)
      fail_at(file_, block.material.line, in_quotes(block.material.name),
              "the name of a material (" + names_of(scene_.materials) + ")");
    std::erase_if(scene_.glows, [&](const Glow& glow) { return glow.material == material; });
    scene_.glows.push_back({material, block.keys});
  }
  std::sort(scene_.glows.begin(), scene_.glows.end(),
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
  MotionCompiler compiler(file, &scene);
  compiler.apply_bodies(blocks.bodies);
  compiler.apply_spots(blocks.spots);
  compiler.apply_glows(blocks.glows);
  NameIndex<Camera> cameras = index_of_names(&scene.cameras);
  for (const Camera& camera : blocks.cameras) cameras.put(camera);
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
