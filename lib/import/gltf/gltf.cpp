// glTF 2.0 files, as scenes.
#include "import/gltf/gltf.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "base/error.h"
#include "base/text.h"
#include "import/gltf/finish.h"
#include "import/gltf/moving.h"
#include "import/gltf/sampler.h"
#include "import/poses/few_scene_keys.h"
#include "import/smooth_normals.h"
#include "import/unique_names.h"
#include "scene/texture.h"
#include "scene/trajectory.h"

namespace strad {
namespace {

constexpr double kFullCone = 179.99 * kDegree;  // a cone must be narrower than a sphere

// A node where it is in the scene.
struct Placed {
  uint32_t node = 0, above = kNone;  // `above`: its parent's place in the list, which comes before
  GltfNode at_rest;                  // with the values of constant channels
  GltfMotion motion;                 // of channels that vary
  GltfTransform parent, world;       // at rest
  uint32_t body = 0;
  Box bounds;           // of the meshes of the node and those below, at rest
  double smallest = 0;  // size of the smallest of these meshes
  bool moves() const { return motion.translation || motion.rotation; }
};

// Moves the alpha below which there are holes to a half.
void set_threshold(double hole_below, Opacity* opacity) {
  if (!(hole_below > 0)) *opacity = {};
  for (uint8_t& value : opacity->values)
    value = static_cast<uint8_t>(std::clamp(std::lround(value - 255 * hole_below + 127.5), 0L, 255L));
}

class GltfBuilder {
 public:
  GltfBuilder(const GltfModel& model, const ImportOptions& options, const GltfOptions& gltf,
              ImportReport* report)
      : model_(model), options_(options), gltf_(gltf), report_(report) {}
  Scene build();

 private:
  void refuse(const std::string& what) const {
    if (!options_.skip_unknown) throw BadInput(model_.file + ": " + what + " is not supported");
    report_->add(what + " left out", model_.file, 1);
  }
  void choose_channels();
  void take_channel(const GltfChannel& channel);
  void place_nodes();
  void settle(Placed* placed, GltfMotion all);
  void measure_meshes();
  size_t deepest_ride() const;
  void make_bodies();
  void drop_idle_bodies();
  void add_mesh(const Placed& placed);
  void add_primitive(const GltfPrimitive& primitive, const Placed& placed, const std::string& name);
  uint32_t material(uint32_t index);
  uint32_t texture(uint32_t image, double hole_below);
  void add_light(const Placed& placed);
  void add_camera(const Placed& placed);
  std::vector<double> key_times(uint32_t body) const;

  const GltfModel& model_;
  const ImportOptions& options_;
  const GltfOptions& gltf_;
  ImportReport* report_;
  std::map<uint32_t, GltfMotion> motions_;  // by node
  double last_time_ = 0;
  bool animated_ = false;
  std::vector<Placed> placed_;
  Scene scene_;
  UniqueNames objects_, materials_, spots_, cameras_, bodies_;
  std::map<uint32_t, uint32_t> material_of_;
  std::map<std::pair<uint32_t, double>, uint32_t> texture_of_;    // by image and GltfMaterial::hole_below
  std::map<std::tuple<float, float, float>, uint32_t> vertices_;  // of the object that is being added
};

void GltfBuilder::take_channel(const GltfChannel& channel) {
  GltfMotion& motion = motions_[channel.node];
  const GltfChannel*& slot = channel.path == GltfPath::kTranslation ? motion.translation
                             : channel.path == GltfPath::kRotation  ? motion.rotation
                                                                    : motion.scale;
  const std::string& name = model_.nodes[channel.node].name;
  if (slot)
    throw BadInput(model_.file + ": several animations move node " + in_quotes(name) +
                   ", choose one with --animation");
  slot = &channel;
  last_time_ = std::max(last_time_, channel.times.back());
  animated_ = true;
  if (channel.path == GltfPath::kScale && !is_constant(channel))
    refuse("scaling that moves, of node " + in_quotes(name));
  if (model_.nodes[channel.node].matrix)
    throw BadInput(model_.file + ": node " + in_quotes(name) + " is animated and has a matrix");
}

void GltfBuilder::choose_channels() {
  std::string known;
  bool found = gltf_.animation.empty();
  for (const GltfAnimation& animation : model_.animations) {
    known += (known.empty() ? "" : ", ") + animation.name;
    if (!gltf_.animation.empty() && animation.name != gltf_.animation) continue;
    found = true;
    for (const std::string& problem : animation.problems)
      refuse(problem + ", in animation " + in_quotes(animation.name) + ",");
    for (const GltfChannel& channel : animation.channels) take_channel(channel);
  }
  if (!found)
    throw BadInput("--animation: found '" + gltf_.animation + "', expected " +
                   (known.empty() ? "none: the file has no animation" : "one of " + known));
}

// Separates channels that vary from those that only set a value.
void GltfBuilder::settle(Placed* placed, GltfMotion all) {
  placed->at_rest = model_.nodes[placed->node];
  GltfNode& node = placed->at_rest;
  if (all.translation) node.translation = vector_at(*all.translation, 0, Side::kFrom);
  if (all.rotation) node.rotation = rotation_at(*all.rotation, 0, Side::kFrom);
  if (all.scale) node.scale = vector_at(*all.scale, 0, Side::kFrom);
  if (all.translation && !is_constant(*all.translation)) placed->motion.translation = all.translation;
  if (all.rotation && !is_constant(*all.rotation)) placed->motion.rotation = all.rotation;
}

// Nodes in the order of the file's lists, parents first. No node has two parents, so that each is met once.
void GltfBuilder::place_nodes() {
  for (const uint32_t root : model_.roots) placed_.push_back({root, kNone, {}, {}, {}, {}, 0, {}, 0});
  for (size_t i = 0; i < placed_.size(); ++i) {
    Placed& placed = placed_[i];
    const auto motion = motions_.find(placed.node);
    settle(&placed, motion == motions_.end() ? GltfMotion{} : motion->second);
    if (placed.above != kNone) placed.parent = placed_[placed.above].world;
    placed.world = placed.parent * rest_transform(placed.at_rest, placed.motion);
    for (const double c : {length2(placed.world.x), length2(placed.world.y), length2(placed.world.z),
                           length2(placed.world.origin)})
      if (!(c < 1e30))
        throw BadInput(model_.file + ": node " + in_quotes(placed.at_rest.name) + " is out of range");
    for (const uint32_t child : model_.nodes[placed.node].children)
      placed_.push_back({child, static_cast<uint32_t>(i), {}, {}, {}, {}, 0, {}, 0});
  }
}

void GltfBuilder::measure_meshes() {
  for (size_t i = placed_.size(); i-- > 0;) {
    Placed& placed = placed_[i];
    if (placed.at_rest.mesh != kNone) {
      Box own;
      for (const GltfPrimitive& primitive : model_.meshes[placed.at_rest.mesh].primitives)
        for (const Vec3 p : primitive.points) own.add(placed.world.point(p));
      const double size = own.empty() ? 0 : own.diagonal();
      if (size > 0 && (placed.smallest == 0 || size < placed.smallest)) placed.smallest = size;
      placed.bounds.add(own);
    }
    if (placed.above == kNone) continue;
    Placed& above = placed_[placed.above];
    above.bounds.add(placed.bounds);
    if (placed.smallest > 0 && (above.smallest == 0 || placed.smallest < above.smallest))
      above.smallest = placed.smallest;
  }
}

// How many nodes whose keys are not as they are in the file move one and the same thing: their errors add up.
size_t GltfBuilder::deepest_ride() const {
  constexpr size_t kFewKeys = 20;  // more may be thinned out
  const auto counts = [](const GltfChannel* channel) {
    return channel &&
           (channel->interpolation == GltfInterpolation::kCubicSpline || channel->times.size() > kFewKeys);
  };
  std::vector<size_t> depth(placed_.size());
  for (size_t i = 0; i < placed_.size(); ++i) {
    const Placed& placed = placed_[i];
    depth[i] = (placed.above == kNone ? 0 : depth[placed.above]) +
               (counts(placed.motion.translation) || counts(placed.motion.rotation) ? 1 : 0);
  }
  return std::max<size_t>(1, *std::max_element(depth.begin(), depth.end()));
}

void GltfBuilder::make_bodies() {
  if (placed_.empty()) return;
  const double part = kKeyTolerance / static_cast<double>(deepest_ride());
  Box all;
  for (const Placed& placed : placed_) {
    all.add(placed.bounds);
    all.add(placed.world.origin);
  }
  for (Placed& placed : placed_) {
    const uint32_t above = placed.above == kNone ? 0 : placed_[placed.above].body;
    placed.body = above;
    if (!placed.moves()) continue;
    const std::string& name = placed.at_rest.name;
    if (placed.motion.rotation && !is_similarity(placed.parent)) {
      refuse("a turn within a scaling that is not uniform, of node " + in_quotes(name));
      continue;
    }
    Box bounds = placed.bounds;
    if (bounds.empty()) bounds.add(placed.world.origin), bounds.add(placed.world.origin + Vec3{1, 1, 1});
    const double size = placed.smallest > 0 ? placed.smallest : std::max(all.diagonal(), 1e-6);
    Body body = moving_body(placed.motion, placed.at_rest, placed.parent, bounds, part * size);
    body.parent = above;
    body.name = bodies_.unique(name == "world" ? "world_node" : name);
    placed.body = static_cast<uint32_t>(scene_.bodies.size());
    scene_.bodies.push_back(std::move(body));
  }
}

uint32_t GltfBuilder::texture(uint32_t image, double hole_below) {
  const auto [found, is_new] = texture_of_.insert({{image, hole_below}, kNone});
  if (!is_new) return found->second;
  const Texture& given = model_.images[image];
  if (given.srgb.empty()) {
    const std::string what = "image " + in_quotes(given.name, 200) + " is missing";
    if (!options_.skip_missing) throw BadInput(model_.file + ": " + what);
    report_->add(what + ": left out", model_.file, 1);
    return kNone;
  }
  scene_.textures.push_back(given);
  set_threshold(hole_below, &scene_.textures.back().opacity);
  return found->second = static_cast<uint32_t>(scene_.textures.size() - 1);
}

uint32_t GltfBuilder::material(uint32_t index) {
  const auto [found, is_new] = material_of_.insert({index, static_cast<uint32_t>(scene_.materials.size())});
  if (!is_new) return found->second;
  Material material{index == kNone ? "default" : model_.materials[index].name, {1, 1, 1}, {}, kNone};
  if (index != kNone) {
    const GltfMaterial& given = model_.materials[index];
    for (const std::string& problem : given.problems)
      refuse(problem + ", of material " + in_quotes(given.name) + ",");
    for (const std::string& note : given.notes) report_->add(note, model_.file, 1);
    material.emission = given.emission;
    if (given.image != kNone) material.texture = texture(given.image, given.hole_below);
    const bool textured = material.texture != kNone;
    set_finish(given, textured ? mean_colour(scene_.textures[material.texture]) : Rgb{1, 1, 1}, &material,
               model_.file, report_);
  }
  material.reflectance = limited_reflectance(material.reflectance, model_.file, 1, report_);
  material.name = materials_.unique(material.name);
  scene_.materials.push_back(material);
  return found->second;
}

void GltfBuilder::add_primitive(const GltfPrimitive& primitive, const Placed& placed,
                                const std::string& name) {
  for (const std::string& problem : primitive.problems)
    refuse(problem + ", of mesh " + in_quotes(name) + ",");
  if (primitive.triangles.empty()) return;
  const uint32_t used = material(primitive.material);
  const bool textured = scene_.materials[used].texture != kNone && !primitive.uvs.empty();
  const auto first_uv = static_cast<uint32_t>(scene_.uvs.size());
  if (textured) scene_.uvs.insert(scene_.uvs.end(), primitive.uvs.begin(), primitive.uvs.end());
  // Corners that differ only in their normals are one vertex.
  std::vector<uint32_t> vertex_of;
  for (const Vec3 p : primitive.points) {
    const Vec3 at = placed.world.point(p);
    const std::tuple key{static_cast<float>(at.x) + 0.0f, static_cast<float>(at.y) + 0.0f,
                         static_cast<float>(at.z) + 0.0f};
    const auto [found, is_new] = vertices_.insert({key, static_cast<uint32_t>(scene_.vertices.size())});
    if (is_new) scene_.vertices.push_back({std::get<0>(key), std::get<1>(key), std::get<2>(key)});
    vertex_of.push_back(found->second);
  }
  for (const auto& triangle : primitive.triangles) {
    Polygon polygon;
    for (size_t c = 0; c < 3; ++c) {
      const uint32_t corner = triangle[placed.world.mirrors() ? 2 - c : c];
      polygon.corners[c] = vertex_of[corner];
      if (textured) polygon.uvs[c] = first_uv + corner;
    }
    polygon.material = used;
    polygon.object = static_cast<uint32_t>(scene_.objects.size() - 1);
    const Vec3 a = scene_.vertices[polygon.corners[0]], b = scene_.vertices[polygon.corners[1]],
               c = scene_.vertices[polygon.corners[2]];
    const double longest = std::max({length2(b - a), length2(c - b), length2(a - c)});
    if (length(cross(b - a, c - a)) > 1e-7 * longest)
      scene_.polygons.push_back(polygon);
    else
      report_->add("degenerate face left out", model_.file, 1);
  }
}

void GltfBuilder::add_mesh(const Placed& placed) {
  if (placed.at_rest.skinned) refuse("a skin, of node " + in_quotes(placed.at_rest.name) + ",");
  vertices_.clear();
  scene_.objects.push_back({objects_.unique(placed.at_rest.name), placed.body});
  const size_t before = scene_.polygons.size();
  for (const GltfPrimitive& primitive : model_.meshes[placed.at_rest.mesh].primitives)
    add_primitive(primitive, placed, placed.at_rest.name);
  if (scene_.polygons.size() == before) scene_.objects.pop_back();
}

void GltfBuilder::add_light(const Placed& placed) {
  const GltfLight& light = model_.lights[placed.at_rest.light];
  if (light.type != "spot" && light.type != "point")
    return refuse(light.type + " light " + in_quotes(light.name));
  if (is_black(light.intensity)) return;
  const Vec3 at = placed.world.origin, ahead = -normalized(placed.world.z);
  if (!(length(ahead) > 0)) return refuse("a light of no direction, " + in_quotes(light.name) + ",");
  const auto lumens = static_cast<float>(gltf_.lumens_per_watt);
  const Rgb watts{light.intensity.r / lumens, light.intensity.g / lumens, light.intensity.b / lumens};
  Spot spot{spots_.unique(placed.at_rest.name), placed.body, kFullCone, kFullCone, {}};
  if (light.type == "spot") spot.inner = light.inner, spot.outer = light.outer;
  spot.keys.push_back({0, at, at + ahead, watts});
  scene_.spots.push_back(std::move(spot));
}

// Times of the keys of a body and of those it rides on; before a step, the instant just before it, too.
std::vector<double> GltfBuilder::key_times(uint32_t body) const {
  std::vector<double> times{0, last_time_};
  for (; body != 0; body = scene_.bodies[body].parent) {
    const std::vector<BodyKey>& keys = scene_.bodies[body].keys;
    for (size_t i = 0; i < keys.size(); ++i) {
      times.push_back(keys[i].time);
      if (i > 0 && keys[i].time == keys[i - 1].time) times.push_back(std::nextafter(keys[i].time, -1));
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

// Cameras do not ride on bodies: theirs are keys in the world, on ways that turn about bodies close enough to
// follow them.
void GltfBuilder::add_camera(const Placed& placed) {
  const GltfCamera& camera = model_.cameras[placed.at_rest.camera];
  if (!camera.perspective) return refuse("orthographic camera " + in_quotes(camera.name));
  const Vec3 ahead = -normalized(placed.world.z), up = normalized(placed.world.y);
  if (!(length(cross(ahead, up)) > 1e-6))
    return refuse("a camera of no direction, " + in_quotes(camera.name) + ",");
  const auto key_at = [&](double time) {
    const Pose pose = poses_at(scene_, time)[placed.body];
    const Vec3 from = pose * placed.world.origin;
    return CameraKey{time, from, from + rotate(pose, ahead), rotate(pose, up), camera.yfov};
  };
  std::vector<CameraKey> keys{key_at(0)};
  if (placed.body != 0) {
    constexpr int kParts = 16;  // of a stretch between keys
    const std::vector<double> times = key_times(placed.body);
    for (size_t i = 1; i < times.size(); ++i) {
      for (int part = 1; part < kParts; ++part)
        keys.push_back(key_at(times[i - 1] + part * (times[i] - times[i - 1]) / kParts));
      keys.push_back(key_at(times[i]));
    }
  }
  const double size = std::max(box_of(scene_).diagonal(), 1e-6);
  scene_.cameras.push_back({cameras_.unique(placed.at_rest.name), few_camera_keys(keys, size)});
}

// Bodies that carry nothing, such as those of cameras.
void GltfBuilder::drop_idle_bodies() {
  std::vector<bool> used(scene_.bodies.size());
  used[0] = true;
  for (const Object& object : scene_.objects) used[object.body] = true;
  for (const Spot& spot : scene_.spots) used[spot.body] = true;
  for (size_t body = scene_.bodies.size(); body-- > 1;)
    if (used[body]) used[scene_.bodies[body].parent] = true;
  std::vector<uint32_t> place(scene_.bodies.size());
  std::vector<Body> kept;
  for (size_t body = 0; body < scene_.bodies.size(); ++body) {
    if (!used[body]) continue;
    place[body] = static_cast<uint32_t>(kept.size());
    kept.push_back(std::move(scene_.bodies[body]));
    kept.back().parent = place[kept.back().parent];
  }
  scene_.bodies = std::move(kept);
  for (Object& object : scene_.objects) object.body = place[object.body];
  for (Spot& spot : scene_.spots) spot.body = place[spot.body];
}

Scene GltfBuilder::build() {
  choose_channels();
  place_nodes();
  measure_meshes();
  make_bodies();
  for (const Placed& placed : placed_)
    if (placed.at_rest.mesh != kNone) add_mesh(placed);
  for (const Placed& placed : placed_) {
    if (placed.at_rest.light != kNone) add_light(placed);
    if (placed.at_rest.camera != kNone) add_camera(placed);
  }
  drop_idle_bodies();
  name_bodies(&scene_);
  if (animated_) {
    scene_.rate = gltf_.rate;
    scene_.end = last_time_ + 1 / gltf_.rate;
  }
  return std::move(scene_);
}

}  // namespace

Scene import_gltf(const std::string& path, const ImportOptions& options, const GltfOptions& gltf,
                  ImportReport* report) {
  const GltfModel model = read_gltf(path, options, report);
  Scene scene = GltfBuilder(model, options, gltf, report).build();
  smooth_by_angle(options.smooth, &scene);
  return finish_import(std::move(scene), options, model.file, report);
}

}  // namespace strad
