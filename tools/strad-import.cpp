// strad-import: an OBJ scene, or a POV-Ray one, to a scene stream; with its animation, if it has one.
#include <cmath>
#include <optional>

#include "base/number_list.h"
#include "import/gltf/gltf.h"
#include "import/import.h"
#include "import/obj/obj.h"
#include "import/other_formats.h"
#include "import/pov/ini.h"
#include "import/pov/pov.h"
#include "tool.h"
#include "tool_progress.h"

namespace {

using namespace strad;

constexpr int kMaxSides = 1000;
constexpr int kMostFrames = 1'000'000;

struct ImportTool {
  Common common;
  ImportOptions import;
  std::string path = "-", from, up = "y", provenance;
  std::string frames, clock;
  std::optional<double> rate;
  GltfOptions gltf;
};

MaterialLight parse_light(const std::string& text) {
  const size_t equals = text.rfind('=');
  if (equals == std::string::npos || equals == 0) throw BadInput("--light " + text + ": expected NAME=R,G,B");
  const auto rgb = parse_triple(text.substr(equals + 1), "--light");
  const Rgb radiance{static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])};
  if (radiance.r < 0 || radiance.g < 0 || radiance.b < 0 || !is_finite(radiance))
    throw BadInput("--light " + text + ": expected a radiance of 0 or more");
  return {text.substr(0, equals), radiance};
}

ImportTool parse_options(int argc, char** argv) {
  ImportTool tool;
  std::vector<std::string> lights;
  std::string rate;
  double smooth = 0;
  Options options("strad-import", "Turns an OBJ, POV-Ray or glTF scene or animation into a scene stream.",
                  &tool.common);
  options.file("SCENE", &tool.path, "scene file; standard input when absent or -");
  options.output();
  options.choice("--from", {"obj", "pov", "ini", "gltf"}, &tool.from,
                 "format of SCENE (default: by its extension, else obj)");
  options.text("-f,--frames", "A:B", &tool.frames,
               "frames of a POV-Ray animation, or N for 1:N; or a list of numbers of OBJ files");
  options.text("--clock", "A:B", &tool.clock,
               "clock of a POV-Ray animation in its first and last frame, or A of a still");
  options.text("--rate", "R", &rate, "frames per second of an animation, as 25 or 24000/1001 (default 25)");
  options.text("--animation", "NAME", &tool.gltf.animation, "the animation of a glTF file (default: all)");
  options.number("--lumens-per-watt", "L", &tool.gltf.lumens_per_watt,
                 "what intensities of glTF lights, in candela, are divided by (default 683)");
  options.texts("--light", "NAME=R,G,B", &lights,
                "let materials named NAME, a shell pattern, emit this radiance");
  options.number("--scale", "S", &tool.import.scale, "metres in a unit of SCENE (default 1)");
  options.choice("--up", {"y", "z"}, &tool.up, "upward axis of SCENE, turned so that y is up (default y)");
  options.number("--smooth", "ANGLE", &smooth,
                 "degrees up to which faces that meet are one smooth surface, where the file does not say");
  options.integer("--tessellate", "N", &tool.import.tessellate,
                  "sides of a round POV-Ray object (default 16)");
  options.flag("--skip-missing", &tool.import.skip_missing, "leave out files and materials that are missing");
  options.flag("--skip-unknown", &tool.import.skip_unknown,
               "leave out statements that are not known, and changes that no rigid motion makes");
  options.parse(argc, argv);
  for (const std::string& light : lights) tool.import.lights.push_back(parse_light(light));
  if (!(tool.import.scale > 0)) throw BadInput("--scale: expected a number above 0");
  if (!(smooth >= 0 && smooth <= 180)) throw BadInput("--smooth: expected 0 to 180 degrees");
  tool.import.smooth = smooth * kPi / 180;
  if (tool.import.tessellate < 3 || tool.import.tessellate > kMaxSides)
    throw BadInput("--tessellate: expected 3 to " + std::to_string(kMaxSides) + " sides");
  if (!rate.empty()) tool.rate = parse_ratio(rate, "--rate");
  tool.gltf.rate = tool.rate.value_or(tool.gltf.rate);
  if (!(tool.gltf.lumens_per_watt > 0)) throw BadInput("--lumens-per-watt: expected a number above 0");
  if (tool.rate && !(*tool.rate > 0)) throw BadInput("--rate: expected frames per second, above 0");
  tool.import.up = tool.up[0];
  tool.provenance = options.provenance();
  return tool;
}

// The format of SCENE: obj, pov, ini or gltf.
std::string format_of(const ImportTool& tool) {
  if (!tool.from.empty()) return tool.from;
  if (tool.path.ends_with(".ini")) return "ini";
  if (tool.path.ends_with(".gltf") || tool.path.ends_with(".glb")) return "gltf";
  return tool.path.ends_with(".pov") || tool.path.ends_with(".inc") ? "pov" : "obj";
}

// What the options say in place of an .ini file, or over it.
void set_frames(const ImportTool& tool, PovAnimation* animation) {
  if (!tool.frames.empty()) {
    const std::vector<int> ends = parse_integers(tool.frames, ':', "--frames");
    animation->first = ends.size() == 2 ? ends[0] : 1;
    animation->last = ends.back();
    if (ends.size() > 2 || animation->first < 0 || animation->last <= animation->first ||
        animation->last > kMostFrames)
      fail_option("--frames", tool.frames, "A:B with A below B, or their number N");
    animation->moves = true;
    animation->initial_frame = animation->first;
    animation->final_frame = animation->last;
  }
  if (!tool.clock.empty()) {
    const std::vector<double> ends = parse_numbers(tool.clock, ':', "--clock");
    if (ends.size() > 2 || (ends.size() == 2) != animation->moves)
      fail_option("--clock", tool.clock, animation->moves ? "A:B" : "A, or A:B with --frames");
    animation->run.clock = animation->initial_clock = ends.front();
    animation->run.clock_on = true;
    animation->final_clock = ends.back();
  }
  if (tool.rate) animation->rate = *tool.rate;
}

Scene read_scene(const ImportTool& tool, ImportReport* report) {
  const std::string format = format_of(tool);
  refuse_other_format(tool.path, format);
  if (format == "gltf") {
    if (!tool.frames.empty() || !tool.clock.empty())
      throw BadInput("--frames and --clock: for POV-Ray animations; glTF has times of its own");
    return import_gltf(tool.path, tool.import, tool.gltf, report);
  }
  if (format == "obj") {
    if (!tool.clock.empty()) throw BadInput("--clock: for POV-Ray animations");
    if (tool.frames.empty() && tool.rate) throw BadInput("--rate: for animations, expected --frames, too");
    if (tool.frames.empty()) return import_obj(tool.path, tool.import, report);
    return import_obj_frames({tool.path, parse_number_list("--frames", tool.frames), tool.rate.value_or(25)},
                             tool.import, report, progress_on_stderr(tool.common));
  }
  PovIni ini;
  ini.scene = tool.path;
  if (format == "ini") ini = read_pov_ini(tool.path, tool.import, report);
  set_frames(tool, &ini.animation);
  return import_pov(ini.scene, tool.import, report, ini.animation, progress_on_stderr(tool.common));
}

// What was read; textures, spotlights and cameras only where the file has any.
void tell_counts(const Common& common, const Scene& scene) {
  const auto counted = [](size_t count, const char* what) { return std::to_string(count) + " " + what; };
  if (scene.bodies.size() > 1) {
    size_t keys = 0;
    for (const Body& body : scene.bodies) keys += body.keys.size();
    detail(common, counted(static_cast<size_t>(frame_count(scene)), "frames, ") +
                       counted(scene.bodies.size() - 1, "bodies with ") + counted(keys, "keys"));
  }
  if (scene.textures.size() + scene.spots.size() + scene.cameras.size() > 0) {
    detail(common, counted(scene.textures.size(), "textures, ") +
                       counted(scene.spots.size(), "spotlights, ") +
                       counted(scene.cameras.size(), "cameras"));
  }
  detail(common, counted(scene.polygons.size(), "polygons, ") + counted(scene.objects.size(), "objects, ") +
                     counted(scene.materials.size(), "materials"));
}

int import_scene(const ImportTool& tool) {
  refuse_terminal(tool.common.output);
  ImportReport report;
  Stream stream;
  stream.scene = read_scene(tool, &report);
  for (const std::string& line : report.lines()) note(tool.common, line);
  tell_counts(tool.common, stream.scene);
  write_stream(std::move(stream), tool.provenance, tool.common);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return strad::run_tool("strad-import", [&] { return import_scene(parse_options(argc, argv)); });
}
