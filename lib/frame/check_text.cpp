#include "frame/check_text.h"

#include <cmath>
#include <cstdio>

#include "solution/facts.h"

namespace strad {
namespace {

template <typename... Values>
std::string printed(const char* format, Values... values) {
  char text[256];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

// A terminal must not be steered by a name in a file, nor a line end early.
std::string plain(std::string name) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) c = '?';
  return name;
}

// Rounded, so that no zero has a sign.
double percent(double fraction) { return std::round(1e4 * fraction) / 100 + 0.0; }

std::string group_line(const CheckTable& table, const CheckGroup& group) {
  const ErrorEstimate& e = group.error;
  const std::string name = table.named ? plain(group.name) : printed("%.4g to %.4g", group.from, group.to);
  return printed("%8.2f %8.2f %8.2f %8.2f %8.2f %8.2f %7.1f %7zu  ", percent(e.rel.value), percent(e.rel.low),
                 percent(e.rel.high), percent(e.bias.value), percent(e.bias.low), percent(e.bias.high),
                 percent(group.share), e.points) +
         name + "\n";
}

double tidy(double x) { return std::abs(x) < 1e-12 ? 0 : x; }

std::string place_line(const WorstPlace& place) {
  const Vec3 p = place.rest_point, n = place.normal;
  return printed("%.9g,%.9g,%.9g,%.6g,%.6g,%.6g", tidy(p.x), tidy(p.y), tidy(p.z), tidy(n.x), tidy(n.y),
                 tidy(n.z));
}

std::string worst_line(const WorstPlace& place) {
  const PointError& e = place.error;
  return place_line(place) +
         printed("  # at %.6g s: %.4g, expected %.4g +- %.2g, on ", place.time, e.solution, e.reference,
                 e.deviation) +
         plain(place.object) + "\n";
}

std::string headline(const char* name, const Confidence& c) {
  return printed("%s %.2f %%, 95 %% confidence %.2f to %.2f %%\n", name, percent(c.value), percent(c.low),
                 percent(c.high));
}

FactGroup interval_facts(const Confidence& interval) {
  return {{"value", {interval.value}}, {"low", {interval.low}}, {"high", {interval.high}}};
}

FactGroup error_facts(const ErrorEstimate& error) {
  return {{"points", {static_cast<double>(error.points)}},
          {"mean", {error.mean}},
          {"rel_rmse", {interval_facts(error.rel)}},
          {"bias", {interval_facts(error.bias)}}};
}

Fact table_fact(const CheckTable& table) {
  FactList list;
  for (const CheckGroup& group : table.groups) {
    FactGroup facts;
    if (table.named) {
      facts.push_back({"name", {group.name}});
    } else {
      facts.push_back({"from", {group.from}});
      facts.push_back({"to", {group.to}});
    }
    for (NamedFact& fact : error_facts(group.error)) facts.push_back(std::move(fact));
    facts.push_back({"share", {group.share}});
    list.push_back({facts});
  }
  return {list};
}

Fact worst_fact(const WorstPlace& place) {
  const PointError& e = place.error;
  return {FactGroup{{"at", {place_line(place)}},
                    {"time", {place.time}},
                    {"object", {place.object}},
                    {"solution", {e.solution}},
                    {"expected", {e.reference}},
                    {"deviation", {e.deviation}}}};
}

}  // namespace

std::string check_text(const CheckReport& report) {
  const ErrorEstimate& e = report.total;
  std::string text = headline("error", e.rel) + headline("bias", e.bias);
  text += printed("mean %.4g W/(sr m^2) of %zu points\n", e.mean, e.points);
  for (const CheckTable& table : report.tables) {
    text += "\n error %      low     high   bias %      low     high share %  points  by " + table.of + "\n";
    for (const CheckGroup& group : table.groups) text += group_line(table, group);
  }
  text += report.worst.empty() ? "\nno place where the error is above the noise\n"
                               : "\nworst places, as strad-probe takes them\n";
  for (const WorstPlace& place : report.worst) text += worst_line(place);
  return text;
}

std::string check_json(const CheckReport& report) {
  FactGroup facts = error_facts(report.total);
  for (const CheckTable& table : report.tables) facts.push_back({table.of, table_fact(table)});
  FactList worst;
  for (const WorstPlace& place : report.worst) worst.push_back(worst_fact(place));
  facts.push_back({"worst", {worst}});
  return to_json({facts});
}

}  // namespace strad
