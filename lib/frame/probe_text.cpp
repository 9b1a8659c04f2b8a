#include "frame/probe_text.h"

#include <charconv>
#include <cstdio>

#include "base/error.h"

namespace strad {
namespace {

constexpr std::string_view kBetween = " \t\r,";

std::vector<double> numbers_in(const std::string& place, std::string_view text, std::string_view between) {
  const std::string expected = "expected X,Y,Z or X,Y,Z,NX,NY,NZ";
  std::vector<double> numbers;
  for (size_t begin = text.find_first_not_of(between); begin < text.size();) {
    const size_t end = std::min(text.find_first_of(between, begin), text.size());
    double number = 0;
    const auto [rest, error] = std::from_chars(text.data() + begin, text.data() + end, number);
    if (error != std::errc() || rest != text.data() + end || !std::isfinite(number)) {
      throw BadInput(place + ": found '" + std::string(text.substr(begin, end - begin)) + "', " + expected);
    }
    numbers.push_back(number);
    begin = text.find_first_not_of(between, end);
  }
  if (numbers.size() == 3 || numbers.size() == 6) return numbers;
  throw BadInput(place + ": found " + std::to_string(numbers.size()) + " numbers, " + expected);
}

ProbeQuery query_of(const std::string& place, const std::vector<double>& n) {
  ProbeQuery query;
  query.position = {n[0], n[1], n[2]};
  if (n.size() == 3) return query;
  query.normal = normalized({n[3], n[4], n[5]});
  if (!(length(*query.normal) > 0))
    throw BadInput(place + ": found a normal of length 0, expected a direction");
  return query;
}

std::string escaped(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (c == ' ' || c == '\t' || c == '\n' || c == '\\') {
      char octal[5];
      std::snprintf(octal, sizeof octal, "\\%03o", static_cast<unsigned>(static_cast<unsigned char>(c)));
      text += octal;
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace

ProbeQuery parse_probe(const std::string& option, std::string_view text) {
  if (text.find(",,") != std::string_view::npos || text.starts_with(',') || text.ends_with(',')) {
    throw BadInput(option + ": found '" + std::string(text) + "', expected X,Y,Z or X,Y,Z,NX,NY,NZ");
  }
  return query_of(option, numbers_in(option, text, ","));
}

std::vector<ProbeQuery> parse_probes(const std::string& name, std::string_view text) {
  std::vector<ProbeQuery> queries;
  for (size_t begin = 0, line = 1; begin < text.size(); ++line) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view content = text.substr(begin, end - begin);
    begin = end + 1;
    content = content.substr(0, content.find('#'));
    if (content.find_first_not_of(kBetween) == std::string_view::npos) continue;
    const std::string place = name + ":" + std::to_string(line);
    queries.push_back(query_of(place, numbers_in(place, content, kBetween)));
  }
  return queries;
}

std::string probe_header() { return "time\tpoint\tobject\tr\tg\tb\ter\teg\teb\n"; }

std::string probe_row(double time, size_t point, const std::string& name, const ProbeValue& value) {
  char text[256];
  std::snprintf(text, sizeof text, "%.9g\t%zu\t", time, point);
  std::string row = text + escaped(name);
  const Rgb l = value.radiance, e = value.irradiance;
  std::snprintf(text, sizeof text, "\t%.7g\t%.7g\t%.7g\t%.7g\t%.7g\t%.7g\n", l.r, l.g, l.b, e.r, e.g, e.b);
  return row + text;
}

}  // namespace strad
