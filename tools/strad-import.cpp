// strad-import: an OBJ scene, or a POV-Ray one, to a scene stream.
#include "import/import.h"
#include "import/obj/obj.h"
#include "import/pov/pov.h"
#include "tool.h"

namespace {

using namespace strad;

constexpr int kMaxSides = 1000;

struct ImportTool {
  Common common;
  ImportOptions import;
  std::string path = "-", from, up = "y", provenance;
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
  Options options("strad-import", "Turns an OBJ or POV-Ray scene into a scene stream.", &tool.common);
  options.file("SCENE", &tool.path, "scene file; standard input when absent or -");
  options.output();
  options.choice("--from", {"obj", "pov"}, &tool.from,
                 "format of SCENE (default: by its extension, else obj)");
  options.texts("--light", "NAME=R,G,B", &lights,
                "let materials named NAME, a shell pattern, emit this radiance");
  options.number("--scale", "S", &tool.import.scale, "metres in a unit of SCENE (default 1)");
  options.choice("--up", {"y", "z"}, &tool.up, "upward axis of SCENE, turned so that y is up (default y)");
  options.integer("--tessellate", "N", &tool.import.tessellate,
                  "sides of a round POV-Ray object (default 16)");
  options.flag("--skip-missing", &tool.import.skip_missing, "leave out files and materials that are missing");
  options.flag("--skip-unknown", &tool.import.skip_unknown, "leave out statements that are not known");
  options.parse(argc, argv);
  for (const std::string& light : lights) tool.import.lights.push_back(parse_light(light));
  if (!(tool.import.scale > 0)) throw BadInput("--scale: expected a number above 0");
  if (tool.import.tessellate < 3 || tool.import.tessellate > kMaxSides)
    throw BadInput("--tessellate: expected 3 to " + std::to_string(kMaxSides) + " sides");
  tool.import.up = tool.up[0];
  tool.provenance = options.provenance();
  return tool;
}

bool is_pov(const ImportTool& tool) {
  if (!tool.from.empty()) return tool.from == "pov";
  return tool.path.ends_with(".pov") || tool.path.ends_with(".inc");
}

// What was read; textures, spotlights and cameras only where the file has any.
void tell_counts(const Common& common, const Scene& scene) {
  const auto counted = [](size_t count, const char* what) { return std::to_string(count) + " " + what; };
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
  stream.scene = is_pov(tool) ? import_pov(tool.path, tool.import, &report)
                              : import_obj(tool.path, tool.import, &report);
  for (const std::string& line : report.lines()) note(tool.common, line);
  tell_counts(tool.common, stream.scene);
  write_stream(std::move(stream), tool.provenance, tool.common);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return strad::run_tool("strad-import", [&] { return import_scene(parse_options(argc, argv)); });
}
