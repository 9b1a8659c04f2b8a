// strad-frame: frames of a solved stream, as pictures, for POV-Ray or as PLY meshes.
#include "export/ply/write_ply.h"
#include "export/pov/write_pov.h"
#include "frame/layered_frame.h"
#include "frame/write_pictures.h"
#include "tool.h"
#include "tool_frame_options.h"
#include "tool_progress.h"

namespace {

using namespace strad;

FrameTool parse_options(int argc, char** argv) {
  FrameTool tool;
  FrameRequest& request = tool.request;
  std::string size = "640x480", direct = "pixel";
  Options options("strad-frame", "Renders frames of a solved stream.", &tool.common);
  options.text("-f,--frames", "LIST", &request.frames,
               "frames, as 1:600, 1:600:10 or 61,150:152 (default: all)");
  options.text("-t,--time", "T[,T...]", &request.times, "instants in seconds, in place of frames");
  options.text("-c,--camera", "NAME", &request.camera, "camera (default: the first)");
  options.text("--camera-at", "KEY", &request.camera_at,
               "a camera of your own in place of the stream's: 'from X Y Z to X Y Z fov A'");
  options.text("-s,--size", "WxH", &size, "size in pixels (default 640x480)");
  options.integer("--samples", "N", &request.raster.samples,
                  "samples of a pixel in which there are edges (default 16)");
  options.integer("--lamp-samples", "N", &request.raster.lamp_samples,
                  "shadow rays to each lamp that is in part hidden, at each corner of a pixel (default 32)");
  options.number("--shutter", "S", &request.shutter,
                 "motion blur: fraction of a frame that the shutter is open, 0 to 1 (default 0)");
  options.choice("--direct", {"pixel", "mesh"}, &direct,
                 "direct light by shadow rays, or from the solution (default pixel)");
  options.flag("--flat", &request.raster.flat, "show the elements of the solution as they are");
  options.flag("--preview", &tool.preview, "show the scene at once, without a solution and without shadows");
  options.flag("--plan", &tool.plan, "show the scene from above: paths, cones of spotlights, the camera");
  options.integer("--reference", "N", &tool.reference,
                  "trace N paths per pixel and leave the solution aside: slow, noisy, unbiased");
  options.integer("--seed", "S", &tool.seed, "of the noise of --reference (default 0)");
  options.choice("--show", {"elements", "error", "openness"}, &tool.show,
                 "in place of light, the mesh, its error, or how open surfaces are");
  options.number("--within", "M", &tool.within,
                 "metres that --show openness looks (default: a tenth of the scene)");
  options.text("--exposure", "EV|auto", &tool.exposure,
               "scale all light by 2^EV (default 0); auto: as the whole animation's brightness asks for");
  options.text("--layers", "LIST", &tool.layers,
               "layers in place of one picture: all, or some of combined, direct, indirect, emission, "
               "specular, albedo, "
               "normal, position, depth, motion, object, material");
  options.choice("--tone", {"linear", "srgb", "filmic"}, &tool.encoding.tone,
                 "how whole numbers follow from light (default srgb)");
  options.number("--white", "W", &tool.encoding.white, "radiance shown as white (default 1, filmic 5.6)");
  options.choice("--depth", {"half", "float", "8", "16"}, &tool.encoding.depth,
                 "numbers in picture files (default: what is usual for the format)");
  options.flag("--pfm", &request.pfm, "linear PFM on standard output in place of PPM");
  options.flag("--pov", &tool.pov, "write files for POV-Ray in place of pictures");
  options.flag("--ply", &tool.ply, "write PLY meshes with light at their vertices in place of pictures");
  options.output("write files; for several frames a pattern such as frame.%04d.exr");
  options.flag("--missing", &request.missing,
               "only frames whose files are absent, damaged or of another stream (EXR and PNG)");
  options.path("--stats", "FILE", &tool.stats, "write what the frames cost to FILE, as JSON");
  options.jobs();
  options.file("STREAM", &request.stream, "the stream; standard input when absent or -");
  // A frame has the same bytes whichever frames are made with it, and from wherever the stream comes.
  for (const char* name : {"-f", "--frames", "-t", "--time", "--stats"}) options.unrecorded(name, true);
  options.unrecorded("--missing", false);
  options.parse(argc, argv);
  const PictureSize pixels = parse_size("--size", size);
  request.raster.width = pixels.width;
  request.raster.height = pixels.height;
  request.raster.direct = direct == "mesh" ? DirectFrom::kMesh : DirectFrom::kPixel;
  request.output = tool.common.output;
  if (!tool.layers.empty()) request.layers = parse_layers("--layers", tool.layers);
  request.all_layers = tool.layers == "all";
  request.auto_exposure = tool.exposure == "auto";
  if (!tool.exposure.empty() && !request.auto_exposure)
    request.exposure = parse_number(tool.exposure, "--exposure");
  check(tool);
  if (!tool.pov && !tool.ply) request.encoding = encoding_of(tool);
  request.software = options.software();
  request.provenance = options.provenance();
  if (!tool.show.empty()) request.show = show_named(tool.show);
  request.within = tool.within.value_or(0);
  request.reference = tool.reference.value_or(0);
  request.seed = static_cast<uint64_t>(tool.seed.value_or(0));
  return tool;
}

int write_frames(FrameTool tool) {
  refuse_terminal(tool.request.output);
  std::vector<FrameCost> costs;
  tool.request.told = [&](const FrameCost& cost) { costs.push_back(cost); };
  const auto progress = progress_on_stderr(tool.common);
  if (tool.pov) {
    write_pov(tool.request, progress);
  } else if (tool.ply) {
    write_ply(tool.request, progress);
  } else if (tool.preview) {
    write_previews(tool.request, progress);
  } else if (tool.plan) {
    write_plans(tool.request, progress);
  } else if (tool.request.reference > 0) {
    write_references(tool.request, progress);
  } else if (tool.request.show) {
    write_shows(tool.request, progress);
  } else {
    const double exposure = write_pictures(tool.request, progress);
    if (tool.request.auto_exposure) detail(tool.common, "exposure " + std::to_string(exposure));
  }
  if (!tool.stats.empty()) write_text_file(tool.stats, costs_as_json(costs));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return strad::run_tool("strad-frame", [&] { return write_frames(parse_options(argc, argv)); });
}
