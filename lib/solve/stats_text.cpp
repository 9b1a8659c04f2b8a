#include "solve/stats_text.h"

#include <cstdio>

namespace strad {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string phase(const PhaseStats& p) {
  const double rate = p.cpu_seconds > 0 ? static_cast<double>(p.rays) / p.cpu_seconds : 0;
  return "{\"cpu_seconds\": " + number(p.cpu_seconds) + ", \"wall_seconds\": " + number(p.wall_seconds) +
         ", \"links\": " + std::to_string(p.links) +
         ", \"links_refined_in_time\": " + std::to_string(p.links_refined_in_time) +
         ", \"links_refined_in_space\": " + std::to_string(p.links_refined_in_space) +
         ", \"kernel_evaluations\": " + std::to_string(p.kernel_evaluations) +
         ", \"rays\": " + std::to_string(p.rays) + ", \"rays_per_second\": " + number(rate) + "}";
}

}  // namespace

std::string stats_as_json(const SolveStats& s) {
  std::string text = "{\n";
  const auto add = [&](const char* name, const PhaseStats& p) {
    text += std::string("  \"") + name + "\": " + phase(p) + ",\n";
  };
  add("prepare", s.prepare);
  add("direct", s.direct);
  add("links", s.links);
  add("bounces", s.bounces);
  add("gather", s.gather);
  add("indirect", s.indirect);
  add("total", s.total);
  return text + "  \"elements\": " + std::to_string(s.elements) +
         ",\n  \"vertices\": " + std::to_string(s.vertices) +
         ",\n  \"clusters\": " + std::to_string(s.clusters) +
         ",\n  \"coefficients\": " + std::to_string(s.coefficients) +
         ",\n  \"bytes\": {\"peak\": " + std::to_string(s.peak_bytes) +
         ", \"links\": " + std::to_string(s.link_bytes) + ", \"mesh\": " + std::to_string(s.mesh_bytes) +
         ", \"functions\": " + std::to_string(s.function_bytes) +
         "},\n  \"iterations\": " + std::to_string(s.iterations) +
         ",\n  \"residual\": " + number(s.residual) + "\n}\n";
}

}  // namespace strad
