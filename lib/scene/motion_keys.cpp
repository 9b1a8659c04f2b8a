// The `key` lines of a motion file.
#include "scene/motion_keys.h"

#include <charconv>
#include <initializer_list>

namespace strad {
namespace {

// Default vertical field of view of a camera, degrees.
constexpr double kDefaultFov = 40;

// The fields found on one line: refuses repeated ones, and tells which are missing.
class FieldNames {
 public:
  void take(const std::string& field, const MotionWords& words) {
    if (has(field)) words.fail("a second " + field, "one " + field + " in a key");
    seen_.push_back(field);
  }
  bool has(const std::string& field) const {
    for (const std::string& seen : seen_)
      if (seen == field) return true;
    return false;
  }
  bool empty() const { return seen_.empty(); }

 private:
  std::vector<std::string> seen_;
};

// Takes the time, then hands each field's name to `take` until the line ends, then appends the key.
template <class Key, class Take>
void take_fields(MotionWords& words, std::vector<Key>& keys, Key first,
                 std::initializer_list<const char*> required, const std::string& expected, Take take) {
  Key key = keys.empty() ? first : keys.back();
  key.time = words.number("a time in seconds");
  FieldNames fields;
  while (!words.at_end()) {
    const std::string field = words.word(expected);
    fields.take(field, words);
    if (!take(field, key)) words.fail(expected);
  }
  if (fields.empty()) words.fail("end of line", expected);
  for (const char* name : required)
    if (keys.empty() && !fields.has(name)) words.fail(std::string("a first key without ") + name, expected);
  const std::string this_time = motion_number(key.time);
  if (!keys.empty() && !(keys.back().time <= key.time))
    words.fail("a key at " + this_time, "one at " + motion_number(keys.back().time) + " or later");
  if (keys.size() >= 2 && keys[keys.size() - 2].time == key.time)
    words.fail("a third key at " + this_time, "at most two at one time");
  keys.push_back(key);
}

Rgb take_intensity(MotionWords& words) {
  const Vec3 rgb = words.vector("the intensity");
  if (!(rgb.x >= 0 && rgb.y >= 0 && rgb.z >= 0))
    words.fail("a negative intensity", "red, green and blue of at least 0");
  return {static_cast<float>(rgb.x), static_cast<float>(rgb.y), static_cast<float>(rgb.z)};
}

Quat take_quat(MotionWords& words) {
  const std::string expected = "the four numbers W X Y Z of the quaternion";
  const double w = words.number(expected);
  const Vec3 v{words.number(expected), words.number(expected), words.number(expected)};
  const double norm = std::sqrt(w * w + length2(v));
  if (!(norm > 0)) words.fail("a quaternion of no length", "a rotation");
  if (is_unit_to_rounding(norm)) return {w, v.x, v.y, v.z};
  return {w / norm, v.x / norm, v.y / norm, v.z / norm};
}

double take_fov(MotionWords& words) {
  const std::string expected = "a field of view in degrees, above 0 and below 180";
  const double fov = words.angle(expected);
  if (!(fov > 0 && fov < kPi)) words.fail(expected);
  return fov;
}

// Whether the camera's view direction and up vector are far enough from parallel to span a plane.
bool has_horizon(const CameraKey& key) {
  const Vec3 view = normalized(key.to - key.from);
  return length(cross(view, normalized(key.up))) > 1e-9;
}

}  // namespace

std::string motion_number(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

void take_key(MotionWords& words, std::vector<BodyKey>& keys) {
  bool has_turn = false, has_quat = false;
  take_fields(words, keys, BodyKey{}, {}, "move, turn or quat", [&](const std::string& field, BodyKey& key) {
    if (field == "move") {
      key.move = words.vector("the move");
    } else if (field == "turn") {
      key.turn = words.angle("an angle in degrees");
      key.has_quat = false;
      key.quat = {};
      has_turn = true;
    } else if (field == "quat") {
      key.quat = take_quat(words);
      key.has_quat = true;
      key.turn = 0;
      has_quat = true;
    } else {
      return false;
    }
    if (has_turn && has_quat) words.fail("both turn and quat", "one of them in a key");
    return true;
  });
}

void take_key(MotionWords& words, std::vector<SpotKey>& keys) {
  take_fields(words, keys, SpotKey{}, {"at", "aim", "intensity"}, "at, aim and intensity",
              [&](const std::string& field, SpotKey& key) {
                if (field == "at")
                  key.at = words.vector("the position");
                else if (field == "aim")
                  key.aim = words.vector("the aim");
                else if (field == "intensity")
                  key.intensity = take_intensity(words);
                else
                  return false;
                return true;
              });
  if (keys.back().at == keys.back().aim) words.fail("a spot that aims at itself", "aim apart from at");
}

void take_key(MotionWords& words, std::vector<GlowKey>& keys) {
  take_fields(words, keys, GlowKey{}, {}, "value", [&](const std::string& field, GlowKey& key) {
    if (field != "value") return false;
    const double value = words.number("a scale of at least 0");
    if (!(value >= 0)) words.fail("a scale of at least 0");
    key.value = static_cast<float>(value);
    return true;
  });
}

void take_key(MotionWords& words, std::vector<CameraKey>& keys) {
  CameraKey first;
  first.fov = kDefaultFov * kDegree;
  take_fields(words, keys, first, {"from", "to"}, "from, to, up and fov",
              [&](const std::string& field, CameraKey& key) {
                if (field == "from")
                  key.from = words.vector("the eye");
                else if (field == "to")
                  key.to = words.vector("the point looked at");
                else if (field == "up")
                  key.up = words.vector("the up direction");
                else if (field == "fov")
                  key.fov = take_fov(words);
                else
                  return false;
                return true;
              });
  if (keys.back().from == keys.back().to)
    words.fail("a camera that looks at its own place", "to apart from from");
  if (!has_horizon(keys.back())) words.fail("an up direction along the view", "one across it");
}

}  // namespace strad
