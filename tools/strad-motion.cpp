// strad-motion: compiles a motion file onto a scene stream: bodies, spotlights, glows, cameras, interval and
// rate. Or prints the motion that a stream has.
#include "base/text.h"
#include "frame/warnings.h"
#include "scene/motion_io.h"
#include "scene/motion_print.h"
#include "scene/motion_text.h"
#include "scene/remarks.h"
#include "solution/slab_work.h"
#include "tool.h"

namespace {

using namespace strad;

struct MotionTool {
  Common common;
  std::string motion, stream, provenance;
  bool print = false;
};

bool is_standard_input(const std::string& name) { return name.empty() || name == "-"; }

MotionTool parse_options(int argc, char** argv) {
  MotionTool tool;
  Options options("strad-motion",
                  "Compiles a motion file onto a scene stream: bodies, spotlights, glows, cameras, "
                  "interval and rate.",
                  &tool.common);
  options.flag("--print", &tool.print, "print the motion of STREAM, without MOTION, as a motion file");
  options.output();
  options.file("MOTION", &tool.motion, "motion file, see strad-motion(5); -: standard input");
  options.file("STREAM", &tool.stream, "scene stream; absent or -: standard input");
  options.parse(argc, argv);
  tool.provenance = options.provenance();
  if (tool.print) {
    if (!tool.stream.empty()) throw BadInput("--print: found two names, expected STREAM alone");
    tool.stream = tool.motion;
  } else if (tool.motion.empty()) {
    throw BadInput("found no name, expected MOTION and STREAM; see strad-motion --help");
  } else if (tool.motion == "-" && is_standard_input(tool.stream)) {
    throw BadInput("standard input cannot be both MOTION and STREAM: name a file for one of them");
  }
  return tool;
}

// All that a motion file can change, in bytes.
struct MotionBytes {
  Bytes all, of_light;
};

MotionBytes motion_bytes(const Scene& scene) {
  MotionBytes bytes;
  put_motion(&bytes.all, scene);
  bytes.of_light = motion_of_light(scene);
  return bytes;
}

int print(const MotionTool& tool) {
  write_text_file(tool.common.output, print_motion(read_stream(tool.stream).scene));
  return 0;
}

int compile(const MotionTool& tool) {
  const std::string text = read_text(tool.motion);
  Stream stream = read_stream(tool.stream);
  const MotionBytes before = motion_bytes(stream.scene);
  apply_motion(text, text_name(tool.motion), stream.scene);
  for (const std::string& name : dark_glows(stream.scene))
    note(tool.common, "glow " + in_quotes(name) + ": the material emits nothing, and stays dark");
  const MotionBytes after = motion_bytes(stream.scene);
  if (stream.solution && before.of_light != after.of_light) {
    // It is the light of the scene as it moved before.
    stream.solution.reset();
    drop_work(&stream.others);
    note(tool.common, "the stream's solution is dropped, for the motion has changed: solve again");
  }
  if (!tool.common.quiet)
    for (const std::string& warning : warnings_of(stream.scene)) note(tool.common, "warning: " + warning);
  detail(tool.common, stream_summary(tool.motion, stream));
  const bool changed = before.all != after.all || before.of_light != after.of_light;
  write_stream(std::move(stream), changed ? tool.provenance : "", tool.common);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return strad::run_tool("strad-motion", [&] {
    const MotionTool tool = parse_options(argc, argv);
    return tool.print ? print(tool) : compile(tool);
  });
}
