#include "tool_frame_options.h"

#include <cmath>

#include "base/error.h"
#include "frame/layered_frame.h"
#include "image/files.h"
#include "tool_words.h"

namespace strad {
namespace {

constexpr int kMaxSamples = 65536;
constexpr int kMaxPaths = 100'000'000;

void check_reference(const FrameTool& tool) {
  if (tool.seed && !tool.reference) throw BadInput("--seed: for --reference only");
  if (tool.seed && *tool.seed < 0) fail_option("--seed", std::to_string(*tool.seed), "0 or more");
  if (!tool.reference) return;
  if (*tool.reference < 1 || *tool.reference > kMaxPaths) {
    fail_option("--reference", std::to_string(*tool.reference), "1 to " + std::to_string(kMaxPaths));
  }
  if (tool.pov || tool.ply) throw BadInput("--reference: for pictures, without --pov and --ply");
  if (tool.request.raster.flat) throw BadInput("--reference and --flat: found both, expected one of them");
}

void check_show(const FrameTool& tool) {
  if (tool.within && tool.show != "openness") throw BadInput("--within: for --show openness only");
  if (tool.within && !(*tool.within > 0 && std::isfinite(*tool.within)))
    throw BadInput("--within: expected a length above 0 m");
  if (tool.show.empty()) return;
  if (tool.pov || tool.ply || tool.reference || tool.request.raster.flat || tool.request.shutter > 0)
    throw BadInput("--show: for pictures, without --pov, --ply, --reference, --flat and --shutter");
  if (!tool.encoding.tone.empty()) throw BadInput("--show and --tone: found both, expected one of them");
}

void require_solution_pictures(const FrameTool& tool, const std::string& option) {
  if (tool.pov || tool.ply || tool.reference || !tool.show.empty() || tool.preview || tool.plan)
    throw BadInput(option +
                   ": for pictures of the solution, without --pov, --ply, --reference, --show, --preview "
                   "and --plan");
}

void check_encoding(const FrameTool& tool) {
  const bool words = !tool.encoding.tone.empty() || !tool.encoding.depth.empty() || tool.encoding.white;
  if ((tool.pov || tool.ply) && words)
    throw BadInput("--tone, --white and --depth: for pictures, without --pov and --ply");
  if (tool.request.auto_exposure) require_solution_pictures(tool, "--exposure auto");
}

void check_layers(const FrameTool& tool) {
  if (tool.layers.empty()) return;
  require_solution_pictures(tool, "--layers");
  require_layer_files(tool.request.output, tool.request.layers);
}

// Only these formats say what a file shows.
void check_missing(const FrameTool& tool) {
  if (tool.pov || tool.ply) {
    if (tool.request.missing || !tool.stats.empty())
      throw BadInput("--missing and --stats: for pictures, without --pov and --ply");
    return;
  }
  const std::string format = format_of(tool.request.output);
  if (tool.request.missing && format != "exr" && format != "png")
    throw BadInput("--missing: expected -o PATTERN of EXR or PNG files, such as -o 'frame.%04d.exr'");
}

void check_preview(const FrameTool& tool) {
  if (!tool.preview && !tool.plan) return;
  const std::string option = tool.preview ? "--preview" : "--plan";
  if (tool.preview && tool.plan) throw BadInput("--preview and --plan: found both, expected one of them");
  if (tool.pov || tool.ply || tool.reference || tool.request.raster.flat || !tool.show.empty() ||
      tool.request.shutter > 0)
    throw BadInput(option +
                   ": for pictures, without --pov, --ply, --reference, --flat, --show and --shutter");
}

}  // namespace

// Light is dithered, and false colours are not.
Encoding encoding_of(const FrameTool& tool) {
  const bool pipe = !goes_to_files(tool.request);
  Encoding encoding = parse_encoding(tool.encoding, !pipe              ? tool.request.output
                                                    : tool.request.pfm ? "-.pfm"
                                                                       : "-.ppm");
  encoding.dither = tool.show.empty();
  return encoding;
}

void check(const FrameTool& tool) {
  check_preview(tool);
  check_reference(tool);
  check_show(tool);
  const FrameRequest& request = tool.request;
  if (!request.frames.empty() && !request.times.empty()) {
    throw BadInput("--frames and --time: found both, expected one of them");
  }
  if (!request.camera.empty() && !request.camera_at.empty()) {
    throw BadInput("--camera and --camera-at: found both, expected one of them");
  }
  if (request.raster.samples < 1 || request.raster.samples > kMaxSamples) {
    fail_option("--samples", std::to_string(request.raster.samples), "1 to " + std::to_string(kMaxSamples));
  }
  if (request.raster.lamp_samples < 1 || request.raster.lamp_samples > kMaxSamples) {
    fail_option("--lamp-samples", std::to_string(request.raster.lamp_samples),
                "1 to " + std::to_string(kMaxSamples));
  }
  if (!(request.shutter >= 0 && request.shutter <= 1)) {
    throw BadInput("--shutter: expected a fraction of a frame, 0 to 1");
  }
  if (!(std::abs(request.exposure) <= 64)) throw BadInput("--exposure: expected -64 to 64 stops, or auto");
  if (tool.pov && tool.ply) throw BadInput("--pov and --ply: found both, expected one of them");
  if (request.pfm && (goes_to_files(request) || tool.pov || tool.ply)) {
    throw BadInput("--pfm: for pictures on standard output; a file's format follows from its name");
  }
  if (tool.pov && !goes_to_files(request))
    throw BadInput("--pov: expected -o PATTERN, such as -o 'frame.%04d.inc'");
  check_encoding(tool);
  check_layers(tool);
  check_missing(tool);
}

}  // namespace strad
