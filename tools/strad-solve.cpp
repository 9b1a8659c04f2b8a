// strad-solve: solves light transport for an animation and adds the solution to the stream.
#include <cmath>
#include <optional>
#include <utility>

#include "scene/remarks.h"
#include "solution/slab_work.h"
#include "solve/links/link_counts.h"
#include "solve/solve.h"
#include "solve/stats_text.h"
#include "tool.h"
#include "tool_progress.h"

namespace {

struct SolveArguments {
  strad::Common common;
  strad::SolveOptions solve;
  std::string stream, stats, links, provenance;
  std::optional<std::pair<int, int>> frames;  // of the slab, first and last
};

std::pair<int, int> parse_slab_frames(const std::string& text) {
  const std::vector<double> ends = strad::parse_numbers(text, ':', "--frames");
  if (ends.size() != 2 || !(ends[0] >= 1 && ends[0] <= ends[1] && ends[1] < 1e9) ||
      ends[0] != std::floor(ends[0]) || ends[1] != std::floor(ends[1]))
    throw strad::BadInput("--frames: found '" + text + "', expected A:B with 1 <= A <= B");
  return {static_cast<int>(ends[0]), static_cast<int>(ends[1])};
}

// Slabs of frames that follow on one another meet at the first frame of the later one.
void set_slab(const strad::Scene& scene, std::pair<int, int> frames, strad::SolveOptions* options) {
  const int last = strad::frame_count(scene);
  if (frames.second > last)
    throw strad::BadInput("--frames: found frame " + std::to_string(frames.second) +
                          ", expected at most the last, " + std::to_string(last));
  options->begin = strad::frame_time(scene, frames.first);
  options->end = frames.second == last ? scene.end : strad::frame_time(scene, frames.second + 1);
}

SolveArguments parse_arguments(int argc, char** argv) {
  SolveArguments a;
  std::string basis = "m3", slab, frames;
  bool no_clusters = false;
  strad::Options options("strad-solve", "Solves light transport for a whole animation at once.", &a.common);
  options.output();
  options.jobs();
  options.number("-e,--error", "E", &a.solve.error,
                 "tolerated error, fraction of the scene's mean radiance (0.02)");
  options.number("--dark", "D", &a.solve.dark,
                 "share of bright light below which errors count no more, 0 to 1 (1e-4)");
  options.choice("--basis", {"m1", "m2", "m3"}, &basis,
                 "functions of time: m1 constant (Haar), m2 linear, m3 quadratic (m3)");
  options.text("--time", "A:B", &slab, "solve only the slab from A to B seconds");
  options.text("--frames", "A:B", &frames, "solve only the slab of the frames A to B");
  options.number("--at", "T", &a.solve.instant, "solve the single instant T, seconds");
  options.flag("--no-clusters", &no_clusters, "link surfaces only, for comparison");
  options.path("--stats", "FILE", &a.stats, "write what the solve did and cost to FILE, as JSON");
  options.unrecorded("--stats", true);
  options.path("--links", "FILE", &a.links,
               "write how many links arrive at each leaf to FILE, as a PLY mesh");
  options.unrecorded("--links", true);
  options.file("STREAM", &a.stream, "scene stream; absent or -: standard input");
  options.parse(argc, argv);
  a.solve.order = basis[1] - '0';
  a.solve.clusters = !no_clusters;
  if (!slab.empty()) {
    const std::vector<double> ends = strad::parse_numbers(slab, ':', "--time");
    if (ends.size() != 2 || !(ends[0] < ends[1]))
      throw strad::BadInput("--time: found '" + slab + "', expected A:B with A < B");
    a.solve.begin = ends[0];
    a.solve.end = ends[1];
  }
  if (!frames.empty()) a.frames = parse_slab_frames(frames);
  if (!frames.empty() && (!slab.empty() || a.solve.instant))
    throw strad::BadInput("--frames, --time and --at: found several, expected one of them");
  a.provenance = options.provenance();
  return a;
}

int solve(const SolveArguments& a) {
  strad::refuse_terminal(a.common.output);
  strad::Stream stream = strad::read_stream(a.stream);
  if (!strad::is_lit(stream.scene))
    strad::note(a.common, "the scene has no light: no polygon emits, and there is no spotlight");
  strad::SolveOptions options = a.solve;
  if (a.frames) set_slab(stream.scene, *a.frames, &options);
  std::string links;
  if (!a.links.empty())
    options.look_at_links = [&](const auto& tree, const auto& table) { links = links_as_ply(tree, table); };
  strad::Solved solved = strad::solve(std::move(stream.scene), options, strad::progress_on_stderr(a.common));
  stream.scene = std::move(solved.scene);
  strad::drop_work(&stream.others);
  stream.others.push_back(strad::encode_work(solved.work));
  stream.solution.emplace().slabs.push_back(std::move(solved.slab));
  strad::write_stream(std::move(stream), a.provenance, a.common);
  if (!a.links.empty()) strad::write_text_file(a.links, links);
  if (!a.stats.empty()) strad::write_text_file(a.stats, strad::stats_as_json(solved.stats));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return strad::run_tool("strad-solve", [&] { return solve(parse_arguments(argc, argv)); });
}
