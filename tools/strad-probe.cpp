// strad-probe: radiance and irradiance at points of surfaces over time, as a table.
#include <cstdio>
#include <optional>

#include "base/text.h"
#include "frame/frame_list.h"
#include "frame/probe_text.h"
#include "solution/solution_file.h"
#include "tool.h"

namespace {

using namespace strad;

constexpr int kMaxSamples = 10'000'000;
constexpr double kFar = 0.25;  // of the scene's diagonal: further from any surface no point is meant

struct ProbeTool {
  Common common;
  std::string stream;
  std::vector<ProbeQuery> queries;
  ProbeOptions probe;
  int samples = 101;
  bool frames = false;
};

ProbeDirect direct_of(const std::string& word) {
  if (word == "mesh") return ProbeDirect::kMesh;
  return word == "none" ? ProbeDirect::kNone : ProbeDirect::kPoint;
}

ProbeTool parse_options(int argc, char** argv) {
  ProbeTool tool;
  std::vector<std::string> at;
  std::string points, direct = "pixel";
  std::optional<int> samples;
  Options options("strad-probe", "Tells radiance and irradiance at points over time.", &tool.common);
  options.texts(
      "--at", "X,Y,Z[,NX,NY,NZ]", &at,
      "the surface nearest to this point at rest, its side that faces N (default front); repeatable");
  options.path("--points", "FILE", &points, "more points from FILE, one a line");
  options.integer("-n,--samples", "N", &samples, "instants, from the beginning to the end (default 101)");
  options.flag("--frames", &tool.frames, "at the frames of the animation instead");
  options.choice("--direct", {"pixel", "mesh", "none"}, &direct,
                 "direct light by shadow rays, from the solution, or left out (default pixel)");
  options.flag("--flat", &tool.probe.flat, "the elements of the solution as they are, in space and time");
  options.output();
  options.jobs();
  options.file("STREAM", &tool.stream, "the stream; standard input when absent or -");
  options.parse(argc, argv);
  if (samples && tool.frames) throw BadInput("--samples and --frames: found both, expected one of them");
  tool.samples = samples.value_or(tool.samples);
  if (tool.samples < 1 || tool.samples > kMaxSamples) {
    fail_option("--samples", std::to_string(tool.samples), "1 to " + std::to_string(kMaxSamples));
  }
  for (const std::string& text : at) tool.queries.push_back(parse_probe("--at", text));
  if (points == "-" && (tool.stream.empty() || tool.stream == "-")) {
    throw BadInput("standard input cannot be both points and stream: name a file for one of them");
  }
  if (!points.empty()) {
    for (const ProbeQuery& query : parse_probes(text_name(points), read_text(points)))
      tool.queries.push_back(query);
  }
  if (tool.queries.empty()) throw BadInput("found no points, expected --at X,Y,Z or --points FILE");
  tool.probe.direct = direct_of(direct);
  return tool;
}

std::vector<double> times_of(const ProbeTool& tool, const SolutionFile& file) {
  std::vector<double> times;
  if (tool.frames) {
    for (const FrameTime& frame : all_frames(file.scene(), {file.begin(), file.end()}))
      times.push_back(frame.time);
    return times;
  }
  const double length = file.end() - file.begin();
  const int count = length > 0 ? tool.samples : 1;
  for (int i = 0; i < count; ++i) times.push_back(file.begin() + (count > 1 ? length * i / (count - 1) : 0));
  return times;
}

// Where a point was put, and how far that is from the position asked for.
std::string placement(const Scene& scene, const ProbeQuery& query, const ProbePoint& point, size_t i) {
  const Vec3 at = point.rest_point;
  char text[160];
  std::snprintf(text, sizeof text, "point %zu: %.6g,%.6g,%.6g, %.3g m from the position asked for, on ", i,
                at.x, at.y, at.z, length(at - query.position));
  return text + scene.objects[scene.polygons[point.polygon].object].name;
}

int probe(const ProbeTool& tool) {
  SolutionFile file(tool.stream);
  const Scene& scene = file.scene();
  std::vector<ProbePoint> points;
  for (const ProbeQuery& query : tool.queries) points.push_back(nearest_point(scene, query));
  Box box;
  for (const Vec3& vertex : scene.vertices) box.add(vertex);
  for (size_t i = 0; i < points.size(); ++i) {
    const bool is_far = length(points[i].rest_point - tool.queries[i].position) > kFar * box.diagonal();
    (is_far ? note : detail)(tool.common, placement(scene, tool.queries[i], points[i], i));
  }
  Probe probe(scene, points, tool.probe);
  Output output(tool.common.output);
  output.write(probe_header());
  for (const double time : times_of(tool, file)) {
    const std::vector<ProbeValue> values = probe.at(file.slab_at(time), time);
    for (size_t i = 0; i < points.size(); ++i) {
      const std::string& name = scene.objects[scene.polygons[points[i].polygon].object].name;
      output.write(probe_row(time, i, name, values[i]));
    }
  }
  output.commit();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return strad::run_tool("strad-probe", [&] { return probe(parse_options(argc, argv)); });
}
