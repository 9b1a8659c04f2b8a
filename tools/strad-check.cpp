// strad-check: the error of a solution, measured against unbiased estimates of its light.
#include <optional>

#include "frame/check_text.h"
#include "frame/frame_request.h"
#include "tool.h"
#include "tool_progress.h"

namespace {

using namespace strad;

constexpr int kAbove = 1;
constexpr int kMostPoints = 1'000'000, kMostPaths = 10'000'000;

struct CheckTool {
  Common common;
  std::string stream, camera, time;
  CheckOptions check;
  std::optional<double> limit;
  bool json = false;
};

uint32_t counted(const char* option, int value, int least, int most) {
  if (value < least || value > most)
    fail_option(option, std::to_string(value), std::to_string(least) + " to " + std::to_string(most));
  return static_cast<uint32_t>(value);
}

CheckTool parse_options(int argc, char** argv) {
  CheckTool tool;
  std::string direct = "pixel";
  int points = static_cast<int>(tool.check.points), paths = static_cast<int>(tool.check.paths), seed = 0;
  std::string picture;
  Options options("strad-check", "Measures the error of a solution.", &tool.common);
  options.number("--limit", "X", &tool.limit,
                 "fail when the error, a fraction of the mean, is surely above X");
  options.flag("--json", &tool.json, "print JSON");
  options.integer("--points", "N", &points, "points and instants to check at (default 1000)");
  options.integer("--paths", "N", &paths, "paths from each of them (default 2048)");
  options.integer("--seed", "S", &seed, "draw other points and paths (default 0)");
  options.text("-t,--time", "A:B", &tool.time, "instants from A to B seconds only (default: all)");
  options.text("-c,--camera", "NAME", &tool.camera,
               "points as the pixels of this camera see them, not by area");
  options.text("-s,--size", "WxH", &picture, "size of its picture in pixels (default 640x480)");
  options.choice("--direct", {"pixel", "mesh"}, &direct,
                 "direct light by shadow rays, as frames have it, or from the solution (default pixel)");
  options.output();
  options.jobs();
  options.file("STREAM", &tool.stream, "the stream; standard input when absent or -");
  options.parse(argc, argv);
  if (tool.limit && !(*tool.limit >= 0)) throw BadInput("--limit: expected 0 or more");
  if (!picture.empty() && tool.camera.empty()) throw BadInput("--size: for --camera only");
  if (!picture.empty()) tool.check.size = parse_size("--size", picture);
  tool.check.points = counted("--points", points, 1, kMostPoints);
  tool.check.paths = counted("--paths", paths, 1, kMostPaths);
  tool.check.seed = counted("--seed", seed, 0, std::numeric_limits<int>::max());
  tool.check.direct = direct == "mesh" ? ProbeDirect::kMesh : ProbeDirect::kPoint;
  return tool;
}

TimeRange range_of(const std::string& time, const SolutionFile& file) {
  const TimeRange solved{file.begin(), file.end()};
  if (time.empty()) return solved;
  const std::vector<double> ends = parse_numbers(time, ':', "--time");
  if (ends.size() != 2 || !(ends[0] <= ends[1]))
    throw BadInput("--time: found '" + time + "', expected A:B with A <= B");
  parse_times(solved, "--time", time.substr(0, time.find(':')) + "," + time.substr(time.find(':') + 1));
  return {ends[0], ends[1]};
}

int check(CheckTool tool) {
  SolutionFile file(tool.stream);
  tool.check.range = range_of(tool.time, file);
  if (!tool.camera.empty()) tool.check.camera = &find_camera(file.scene(), "--camera", tool.camera);
  const std::vector<CheckSample> samples = check_solution(&file, tool.check, progress_on_stderr(tool.common));
  detail(tool.common, std::to_string(samples.size()) + " points count");
  const CheckReport report = report_of(file.scene(), samples, tool.check.range);
  if (!(report.total.mean > 0)) throw BadInput("found no light at any point, expected some to compare with");
  Output output(tool.common.output);
  output.write(tool.json ? check_json(report) : check_text(report));
  output.commit();
  return tool.limit && report.total.rel.low > *tool.limit ? kAbove : 0;
}

}  // namespace

int main(int argc, char** argv) {
  return strad::run_tool("strad-check", [&] { return check(parse_options(argc, argv)); });
}
