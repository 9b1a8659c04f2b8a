// strad-motion: compiles a motion file onto a scene stream: bodies, spotlights, glows, cameras, interval and
// rate.
#include "base/text.h"
#include "scene/motion_text.h"
#include "solution/slab_work.h"
#include "tool.h"

namespace {

struct MotionArguments {
  strad::Common common;
  std::string motion, stream, provenance;
};

MotionArguments parse_arguments(int argc, char** argv) {
  MotionArguments arguments;
  strad::Options options("strad-motion",
                         "Compiles a motion file onto a scene stream: bodies, spotlights, glows, cameras, "
                         "interval and rate.",
                         &arguments.common);
  options.output();
  options.file("MOTION", &arguments.motion, "motion file, see strad-motion(5); -: standard input", true);
  options.file("STREAM", &arguments.stream, "scene stream; absent or -: standard input");
  options.parse(argc, argv);
  arguments.provenance = options.provenance();
  if (arguments.motion == "-" && (arguments.stream.empty() || arguments.stream == "-"))
    throw strad::BadInput("standard input cannot be both MOTION and STREAM: name a file for one of them");
  return arguments;
}

int compile_motion(const MotionArguments& arguments) {
  const std::string text = strad::read_text(arguments.motion);
  strad::Stream stream = strad::read_stream(arguments.stream);
  strad::apply_motion(text, strad::text_name(arguments.motion), stream.scene);
  if (stream.solution) {
    // It is the light of the scene as it moved before.
    stream.solution.reset();
    strad::drop_work(&stream.others);
    strad::note(arguments.common,
                "the stream's solution is dropped, for the motion has changed: solve again");
  }
  strad::detail(arguments.common, strad::stream_summary(arguments.motion, stream));
  strad::write_stream(std::move(stream), arguments.provenance, arguments.common);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return strad::run_tool("strad-motion", [&] { return compile_motion(parse_arguments(argc, argv)); });
}
