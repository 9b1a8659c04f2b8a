// Numbered OBJ files, one a frame, as scenes that move.
#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/error.h"
#include "base/file_pattern.h"
#include "base/text.h"
#include "import/obj/file.h"
#include "import/obj/obj.h"
#include "import/poses/body_keys.h"
#include "import/poses/few_scene_keys.h"

namespace strad {
namespace {

// How far the numbers of a text may be from what was meant: half a unit of the last digit that is written.
// Numbers with less than six digits, as people write them, are meant as they are.
class TextPrecision {
 public:
  void add(std::string_view number) {
    const size_t exponent = number.find_first_of("eE");
    const std::string_view digits = number.substr(0, exponent);
    const size_t point = std::min(digits.find('.'), digits.size());
    const size_t decimals = point < digits.size() ? digits.size() - point - 1 : 0;
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const auto count = static_cast<size_t>(std::count_if(digits.begin(), digits.end(), is_digit));
    const auto shift =
        exponent == std::string_view::npos ? 0 : integer_in(number.substr(exponent + 1)).value_or(0);
    constexpr size_t kMeant = 6, kExact = 15;
    if (count < kMeant || count > kExact) return;
    const double unit = std::pow(10, static_cast<double>(shift) - static_cast<double>(decimals));
    precision_ = std::max(precision_, unit / 2);
  }
  double precision() const { return precision_; }

 private:
  double precision_ = 0;
};

// Of the coordinates of vertices, which are floats besides.
double precision_of(std::string_view text, const std::vector<Vec3>& vertices) {
  TextPrecision precision;
  LineReader lines(text);
  while (lines.next()) {
    std::string_view rest = lines.line();
    if (next_word(&rest) != "v") continue;
    for (int i = 0; i < 3; ++i) precision.add(next_word(&rest));
  }
  double largest = 0;
  for (const Vec3 v : vertices) largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return std::max(precision.precision(), 0x1p-24 * largest);
}

// The vertices that the faces of each object use, ascending.
std::vector<std::vector<uint32_t>> vertices_of_objects(const ObjFile& file) {
  std::vector<std::vector<uint32_t>> used(file.scan.objects.size());
  for (const ParsedObj::Face& face : file.obj.faces)
    for (uint32_t k = 0; k < face.corner_count; ++k)
      used[face.object].push_back(file.obj.corners[face.first_corner + k].vertex);
  for (std::vector<uint32_t>& vertices : used) {
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  }
  return used;
}

bool same_names(const std::vector<ObjScan::Named>& a, const std::vector<ObjScan::Named>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x.name == y.name; });
}

bool same_face(const ObjFile& a, const ObjFile& b, size_t i) {
  const ParsedObj::Face &f = a.obj.faces[i], &g = b.obj.faces[i];
  if (f.corner_count != g.corner_count || f.object != g.object || f.material != g.material) return false;
  for (uint32_t k = 0; k < f.corner_count; ++k)
    if (a.obj.corners[f.first_corner + k].vertex != b.obj.corners[g.first_corner + k].vertex) return false;
  return true;
}

void require_same_topology(const ObjFile& first, const ObjFile& now) {
  const auto count = [&](size_t found, size_t expected, const char* what) {
    if (found != expected)
      throw BadInput(now.name + ": has " + std::to_string(found) + " " + what + ", expected " +
                     std::to_string(expected) + " as in " + first.name);
  };
  count(now.obj.vertices.size(), first.obj.vertices.size(), "vertices");
  count(now.obj.faces.size(), first.obj.faces.size(), "faces");
  if (!same_names(first.scan.objects, now.scan.objects))
    throw BadInput(now.name + ": its objects are not those of " + first.name);
  if (!same_names(first.scan.materials, now.scan.materials))
    throw BadInput(now.name + ": its materials are not those of " + first.name);
  for (size_t i = 0; i < now.obj.faces.size(); ++i)
    if (!same_face(first, now, i))
      fail_at(now.name, now.scan.face_lines[i], "the face is not the same as in " + first.name);
}

std::vector<Vec3> picked(const std::vector<Vec3>& all, const std::vector<uint32_t>& which) {
  std::vector<Vec3> points;
  points.reserve(which.size());
  for (const uint32_t i : which) points.push_back(all[i]);
  return points;
}

}  // namespace

Scene import_obj_frames(const ObjFrames& frames, const ImportOptions& options, ImportReport* report,
                        const Progress& progress) {
  const FilePattern pattern("SCENE", frames.pattern);
  if (!pattern.numbered())
    throw BadInput("SCENE: found '" + frames.pattern + "', expected a number in it, such as walk.%04d.obj");
  const std::string path = pattern.name(frames.numbers[0]);
  ObjFile first = read_obj(path, options, report);
  const std::vector<std::vector<uint32_t>> used = vertices_of_objects(first);
  std::vector<std::vector<Vec3>> rest, now(used.size());
  for (const std::vector<uint32_t>& vertices : used) rest.push_back(picked(first.obj.vertices, vertices));
  PoseFollower follower({rest.begin(), rest.end()}, precision_of(read_text(path), first.obj.vertices));
  std::vector<double> times{0};
  for (size_t i = 1; i < frames.numbers.size(); ++i) {
    if (progress) progress(static_cast<double>(i) / static_cast<double>(frames.numbers.size()), "files");
    ImportReport again;  // of what the first file's has told
    const ObjFile file = read_obj(pattern.name(frames.numbers[i]), options, &again);
    require_same_topology(first, file);
    for (size_t object = 0; object < used.size(); ++object)
      now[object] = picked(file.obj.vertices, used[object]);
    for (const uint32_t object :
         follower.add_frame([&](uint32_t piece) { return std::span<const Vec3>(now[piece]); })) {
      const ObjScan::Named& named = first.scan.objects[object];
      const std::string what = "the object " + in_quotes(named.name) + " changes its shape in " + file.name;
      if (!options.skip_unknown) fail_at(first.name, named.line, what);
      report->add(what + ": kept as it is in " + first.name, first.name, named.line);
    }
    times.push_back(static_cast<double>(i) / frames.rate);
  }
  std::vector<uint32_t> bodies(used.size(), 0);
  std::vector<Body> moving;
  for (size_t group = 1; group < follower.groups().size(); ++group) {
    if (follower.groups()[group].pieces.empty()) continue;
    moving.push_back(body_of_group(follower, group, times));
    for (const uint32_t object : follower.groups()[group].pieces)
      bodies[object] = static_cast<uint32_t>(moving.size());
  }
  const std::string name = first.name;
  Scene scene = scene_of(std::move(first), bodies, std::move(moving), options, report);
  name_bodies(&scene);
  scene.rate = frames.rate;
  scene.end = static_cast<double>(times.size()) / frames.rate;
  return finish_import(std::move(scene), options, name, report);
}

}  // namespace strad
