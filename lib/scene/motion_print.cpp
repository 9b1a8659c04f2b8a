// A scene's motion as a motion file.
#include "scene/motion_print.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "scene/motion_keys.h"
#include "scene/motion_words.h"

namespace strad {
namespace {

constexpr size_t kLongestLine = 100;

std::string number(double value) { return motion_number(value); }

std::string number(float value) {
  char text[32];
  const char* end = std::to_chars(text, text + sizeof text, value).ptr;
  // Numbers are read as doubles, which could round it to another float.
  const std::string_view shortest(text, static_cast<size_t>(end - text));
  const std::optional<double> read = number_in(shortest);
  return read && static_cast<float>(*read) == value ? std::string(shortest) : number(double{value});
}

std::string numbers(Vec3 v) { return number(v.x) + " " + number(v.y) + " " + number(v.z); }
std::string numbers(Rgb c) { return number(c.r) + " " + number(c.g) + " " + number(c.b); }

// In degrees if any number of degrees reads back as this angle, else in radians.
std::string angle(double radians) {
  const double near = radians / kDegree;
  std::string best;
  for (const double degrees : {near, std::nextafter(near, -HUGE_VAL), std::nextafter(near, HUGE_VAL)}) {
    if (!(degrees * kDegree == radians)) continue;
    if (best.empty() || number(degrees).size() < best.size()) best = number(degrees);
  }
  return best.empty() ? number(radians) + std::string(kRadians) : best;
}

// 24000/1001 where the rate is one of the broadcast rates.
std::string rate(double frames_per_second) {
  const double thousands = std::round(frames_per_second * 1.001);
  if (thousands * 1000 / 1001 == frames_per_second) return number(thousands * 1000) + "/1001";
  return number(frames_per_second);
}

std::string word(const std::string& name) {
  const bool bare =
      !name.empty() && name.front() != '"' &&
      std::none_of(name.begin(), name.end(), [](char c) { return (c >= '\0' && c <= ' ') || c == '#'; });
  if (bare) return name;
  if (name.find_first_of(std::string_view("\"\n\0", 3)) != std::string::npos)
    throw BadInput("the name " + in_quotes(name) + " cannot be written in a motion file");
  return '"' + name + '"';
}

bool is_plain_zero(Vec3 v) {
  return v == Vec3{} && !std::signbit(v.x) && !std::signbit(v.y) && !std::signbit(v.z);
}

void print_parts(const std::vector<std::string>& parts, std::string* text) {
  std::string line;
  for (const std::string& part : parts) {
    const std::string next = " " + word(part);
    if (!line.empty() && line.size() + next.size() > kLongestLine) *text += line + "\n", line.clear();
    line += (line.empty() ? "  parts" : "") + next;
  }
  if (!line.empty()) *text += line + "\n";
}

// Fields that are zero in all keys are left out.
void print_keys(const Body& body, std::string* text) {
  const auto& keys = body.keys;
  const bool turns = std::any_of(keys.begin(), keys.end(), [](const BodyKey& key) {
    return key.has_quat || key.turn != 0 || std::signbit(key.turn);
  });
  const bool moves = !turns || std::any_of(keys.begin(), keys.end(),
                                           [](const BodyKey& key) { return !is_plain_zero(key.move); });
  for (const BodyKey& key : keys) {
    *text += "  key " + number(key.time);
    if (moves) *text += "  move " + numbers(key.move);
    const Quat q = key.quat;
    if (key.has_quat)
      *text += "  quat " + number(q.w) + " " + numbers(Vec3{q.x, q.y, q.z});
    else if (turns)
      *text += "  turn " + angle(key.turn);
    *text += "\n";
  }
}

void print_body(const Scene& scene, uint32_t index, std::string* text) {
  const Body& body = scene.bodies[index];
  *text += "\nbody " + word(body.name) + "\n";
  if (!body.parts.empty()) {
    print_parts(body.parts, text);
  } else {
    std::vector<std::string> names;
    for (const Object& object : scene.objects)
      if (object.body == index) names.push_back(pattern_of(object.name));
    print_parts(names, text);
  }
  if (body.parent != 0) *text += "  on " + word(scene.bodies[body.parent].name) + "\n";
  if (!is_plain_zero(body.pivot)) *text += "  pivot " + numbers(body.pivot) + "\n";
  if (!is_plain_zero(body.axis - Vec3{0, 1, 0})) *text += "  axis " + numbers(body.axis) + "\n";
  if (body.ease == Ease::kSmooth) *text += "  ease smooth\n";
  print_keys(body, text);
}

void print_spot(const Scene& scene, const Spot& spot, std::string* text) {
  *text += "\nspot " + word(spot.name) + "\n";
  if (spot.body != 0) *text += "  on " + word(scene.bodies[spot.body].name) + "\n";
  *text += "  cone " + angle(spot.inner) + " " + angle(spot.outer) + "\n";
  for (const SpotKey& key : spot.keys)
    *text += "  key " + number(key.time) + "  at " + numbers(key.at) + "  aim " + numbers(key.aim) +
             "  intensity " + numbers(key.intensity) + "\n";
}

void print_glow(const Scene& scene, const Glow& glow, std::string* text) {
  *text += "\nglow " + word(scene.materials[glow.material].name) + "\n";
  for (const GlowKey& key : glow.keys)
    *text += "  key " + number(key.time) + "  value " + number(key.value) + "\n";
}

void print_camera(const Camera& camera, std::string* text) {
  *text += "\ncamera " + word(camera.name) + "\n";
  for (const CameraKey& key : camera.keys)
    *text += "  key " + number(key.time) + "  from " + numbers(key.from) + "  to " + numbers(key.to) +
             "  up " + numbers(key.up) + "  fov " + angle(key.fov) + "\n";
}

}  // namespace

std::string pattern_of(const std::string& name) {
  std::string pattern;
  for (const char c : name) {
    if (c == '*' || c == '?' || c == '[' || c == '\\') pattern += '\\';
    pattern += c;
  }
  return pattern;
}

std::string print_motion(const Scene& scene) {
  std::string text =
      "time " + number(scene.start) + " " + number(scene.end) + "\nrate " + rate(scene.rate) + "\n";
  for (uint32_t body = 1; body < scene.bodies.size(); ++body) print_body(scene, body, &text);
  for (const Spot& spot : scene.spots) print_spot(scene, spot, &text);
  for (const Glow& glow : scene.glows) print_glow(scene, glow, &text);
  for (const Camera& camera : scene.cameras) print_camera(camera, &text);
  return text;
}

}  // namespace strad
