// strad-diff: how much two pictures, two sequences of pictures or two solutions differ.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>
#include <variant>

#include "base/number_list.h"
#include "frame/compare_frames.h"
#include "frame/frame_request.h"
#include "frame/solution_diff.h"
#include "solution/facts.h"
#include "stream/chunk.h"
#include "tool.h"

namespace {

using namespace strad;

constexpr int kDiffers = 1;

struct DiffOptions {
  Common common;
  FrameFiles files;
  std::string frames;
  std::optional<double> rel_rmse, largest, flicker, jump;
  bool json = false, each = false;
};

DiffOptions parse_options(int argc, char** argv) {
  DiffOptions o;
  Options options("strad-diff", "Difference of two pictures, two sequences of pictures or two solutions.",
                  &o.common);
  options.file("A", &o.files.a, "the reference: a picture, a pattern such as a.%04d.exr, or a stream", true);
  options.file("B", &o.files.b, "what is compared to it");
  options.number("--rel-rmse", "X", &o.rel_rmse, "fail when the RMSE over the mean of A is above X");
  options.number("--max", "X", &o.largest, "fail when the largest difference is above X");
  options.number("--flicker", "X", &o.flicker, "fail when the flicker of sequence B is above X");
  options.text("-f,--frames", "LIST", &o.frames,
               "only these frames of sequences, as 1:600, 1:600:10 or 61,150:152");
  options.path("--image", "OUT", &o.files.heat_map, "write a heat map, white from half the mean of A on");
  options.path("--twin", "A2", &o.files.twin,
               "a second rendering of A, whose noise is independent and is taken out");
  options.path("--ignore", "LABELS", &o.files.labels,
               "leave out pixels that are not 0 in this 8-bit picture");
  options.integer("--ignore-bits", "N", &o.files.label_bits,
                  "of LABELS look at these bits only (default 255)");
  options.number("--jump", "T", &o.jump,
                 "how much the solution A jumps at T seconds, in place of a difference");
  options.flag("--each", &o.each, "a line for each pair of pictures as well");
  options.flag("--json", &o.json, "print one JSON object");
  options.parse(argc, argv);
  return o;
}

bool is_stream(const std::string& path) {
  char magic[sizeof kMagic] = {};
  std::ifstream(path, std::ios::binary).read(magic, sizeof magic);
  return std::memcmp(magic, kMagic, sizeof magic) == 0;
}

Stream read_told(const Common& common, const std::string& path) {
  Stream stream = read_solved(path);
  detail(common, stream_summary(path, stream));
  return stream;
}

// What is printed: a line each, or one JSON object.
class Report {
 public:
  explicit Report(const DiffOptions& options) : options_(options) {}

  void add(const char* name, double value) { facts_.push_back({name, {value}}); }
  void add(const char* name, const std::string& text) { facts_.push_back({name, text_fact(text)}); }
  void add_each(const std::string& file, const Comparison& c) {
    each_.push_back({FactGroup{
        {"file", text_fact(file)}, {"rel_rmse", {rel_rmse(c)}}, {"bias", {bias(c)}}, {"max", {c.largest}}}});
    if (!options_.common.quiet && !options_.json)
      std::printf("%s rel_rmse %.9g bias %.9g max %.9g\n", file.c_str(), rel_rmse(c), bias(c), c.largest);
  }
  void add(const Comparison& c) {
    add("rel_rmse", rel_rmse(c));
    add("bias", bias(c));
    add("mean_a", c.mean_a);
    add("mean_b", c.mean_b);
    add("max", c.largest);
  }
  // Where the largest difference is: its channel and both values.
  void add(const WorstPixel& worst) {
    add("max_channel", std::string(1, "rgb"[worst.channel]));
    add("max_a", worst.a);
    add("max_b", worst.b);
  }
  void print() {
    if (options_.common.quiet) return;
    if (options_.json) {
      if (options_.each) facts_.push_back({"each", {each_}});
      std::fputs(to_json({facts_}).c_str(), stdout);
      return;
    }
    for (const auto& [name, fact] : facts_) {
      if (const double* number = std::get_if<double>(&fact.value))
        std::printf("%s %.9g\n", name.c_str(), *number);
      else
        std::printf("%s %s\n", name.c_str(), std::get<std::string>(fact.value).c_str());
    }
  }

 private:
  const DiffOptions& options_;
  FactGroup facts_;
  FactList each_;
};

// Without any limit every difference counts.
int verdict(const DiffOptions& o, const Comparison& c, std::optional<double> flicker = {}) {
  if (!o.rel_rmse && !o.largest && !o.flicker) return c.largest > 0 ? kDiffers : 0;
  const bool above = (o.rel_rmse && !(strad::rel_rmse(c) <= *o.rel_rmse)) ||
                     (o.largest && !(c.largest <= *o.largest)) || (o.flicker && !(*flicker <= *o.flicker));
  return above ? kDiffers : 0;
}

int diff_frames(const DiffOptions& o) {
  Report report(o);
  const auto tell = [&](const std::string& file, const Comparison& c) {
    if (o.each) report.add_each(file, c);
    char text[120];
    std::snprintf(text, sizeof text, ": rel_rmse %.4g, bias %.4g, max %.4g", rel_rmse(c), bias(c), c.largest);
    detail(o.common, file + text);
  };
  const FramesComparison c = compare_frames(o.files, tell);
  if (o.flicker && !c.flicker_b) throw BadInput("--flicker: found no three consecutive frames");
  report.add("frames", c.frames);
  report.add(c.total);
  report.add("max_file", c.worst_file);
  report.add("max_x", c.total.worst.x);
  report.add("max_y", c.total.worst.y);
  report.add(c.total.worst);
  if (c.flicker_a) report.add("flicker_a", *c.flicker_a);
  if (c.flicker_b) report.add("flicker_b", *c.flicker_b);
  if (c.flicker_excess) report.add("flicker_excess", *c.flicker_excess);
  report.print();
  return verdict(o, c.total, c.flicker_b);
}

int diff_solutions(const DiffOptions& o) {
  if (o.flicker || !o.files.heat_map.empty() || !o.files.twin.empty() || !o.files.labels.empty() ||
      !o.frames.empty() || o.each)
    throw BadInput(o.files.a + ": a solution, which only --rel-rmse, --max and --json are for");
  const Stream a = read_told(o.common, o.files.a), b = read_told(o.common, o.files.b);
  const SolutionsComparison c =
      compare_solutions({o.files.a, a.scene, *a.solution}, {o.files.b, b.scene, *b.solution});
  Report report(o);
  report.add("begin", c.begin);
  report.add("end", c.end);
  report.add(c.total);
  report.add("max_object", c.object);
  char at[96];
  std::snprintf(at, sizeof at, "%.6g,%.6g,%.6g", c.rest_point.x, c.rest_point.y, c.rest_point.z);
  report.add("max_at", std::string(at));
  report.add("max_time", c.time);
  report.add(c.total.worst);
  report.print();
  return verdict(o, c.total);
}

int print_jump(const DiffOptions& o) {
  const Stream a = read_told(o.common, o.files.a);
  const Jump jump = jump_of({o.files.a, a.scene, *a.solution}, *o.jump);
  Report report(o);
  report.add("jump", jump.as_solved);
  report.add("jump_continuous", jump.continuous);
  report.print();
  return 0;
}

int diff(DiffOptions o) {
  if (o.jump) return print_jump(o);
  if (o.files.b.empty()) throw BadInput("found one name, expected two to compare");
  if (!o.frames.empty()) o.files.frames = parse_number_list("--frames", o.frames);
  return is_stream(o.files.a) || is_stream(o.files.b) ? diff_solutions(o) : diff_frames(o);
}

}  // namespace

int main(int argc, char** argv) {
  return strad::run_tool("strad-diff", [&] { return diff(parse_options(argc, argv)); });
}
