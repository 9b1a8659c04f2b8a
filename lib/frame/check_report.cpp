#include "frame/check_report.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "scene/polygon_geometry.h"

namespace strad {
namespace {

// Of fewer points no confidence interval is given.
constexpr size_t kFewest = 10;
constexpr int kTenths = 10;
constexpr size_t kWorst = 10;

using Points = std::vector<PointError>;

CheckGroup group_of(const Points& points, double whole) {
  CheckGroup group;
  group.error = estimate_error(points);
  group.share = whole > 0 ? group.error.squared / whole : 0;
  return group;
}

// Groups by the index `key[i]` of point i into `names`, in order of the names.
CheckTable table_by(const std::string& of, const std::vector<std::string>& names,
                    const std::vector<uint32_t>& keys, const Points& points, double whole) {
  std::map<uint32_t, Points> members;
  for (size_t i = 0; i < points.size(); ++i) members[keys[i]].push_back(points[i]);
  CheckTable table{of, true, {}};
  Points others;
  for (const auto& [key, group] : members) {
    if (group.size() < kFewest) {
      others.insert(others.end(), group.begin(), group.end());
      continue;
    }
    table.groups.push_back(group_of(group, whole));
    table.groups.back().name = names[key];
  }
  if (others.empty()) return table;
  table.groups.push_back(group_of(others, whole));
  table.groups.back().name = "(others)";
  return table;
}

std::vector<std::string> body_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const Body& body : scene.bodies) names.push_back(body.name);
  return names;
}

std::vector<std::string> material_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const Material& material : scene.materials) names.push_back(material.name);
  return names;
}

// Ten groups of equal weight, from the darkest on.
CheckTable table_by_brightness(const Points& points, double whole) {
  std::vector<size_t> order(points.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return points[a].solution < points[b].solution; });
  double total = 0, before = 0;
  for (const PointError& point : points) total += point.weight;
  std::vector<Points> tenths(kTenths);
  for (const size_t i : order) {
    const double middle = (before + points[i].weight / 2) / total;
    tenths[std::min<size_t>(kTenths - 1, static_cast<size_t>(kTenths * middle))].push_back(points[i]);
    before += points[i].weight;
  }
  CheckTable table{"brightness", false, {}};
  for (const Points& tenth : tenths) {
    if (tenth.empty()) continue;
    table.groups.push_back(group_of(tenth, whole));
    table.groups.back().from = tenth.front().solution;
    table.groups.back().to = tenth.back().solution;
  }
  return table;
}

CheckTable table_by_time(const std::vector<CheckSample>& samples, const Points& points, TimeRange range,
                         double whole) {
  const double length = range.end - range.begin;
  std::vector<Points> tenths(kTenths);
  for (size_t i = 0; i < points.size(); ++i) {
    const double at = length > 0 ? (samples[i].point.time - range.begin) / length : 0;
    tenths[std::min<size_t>(kTenths - 1, static_cast<size_t>(kTenths * at))].push_back(points[i]);
  }
  CheckTable table{"time", false, {}};
  for (size_t tenth = 0; tenth < tenths.size(); ++tenth) {
    if (tenths[tenth].empty()) continue;
    table.groups.push_back(group_of(tenths[tenth], whole));
    table.groups.back().from = range.begin + length * static_cast<double>(tenth) / kTenths;
    table.groups.back().to = range.begin + length * static_cast<double>(tenth + 1) / kTenths;
  }
  return table;
}

std::vector<WorstPlace> worst_of(const Scene& scene, const std::vector<CheckSample>& samples,
                                 const Points& points) {
  std::vector<size_t> order;
  for (size_t i = 0; i < points.size(); ++i)
    if (sure_error(points[i]) > 0) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return sure_error(points[a]) > sure_error(points[b]); });
  order.resize(std::min(order.size(), kWorst));
  std::vector<WorstPlace> worst;
  for (const size_t i : order) {
    const CheckPoint& point = samples[i].point;
    const Polygon& polygon = scene.polygons[point.place.polygon];
    const Vec3 front = polygon_normal(scene, polygon);
    worst.push_back({point.place.rest_point, point.place.front ? front : -front, point.time,
                     scene.objects[polygon.object].name, points[i]});
  }
  return worst;
}

}  // namespace

CheckReport report_of(const Scene& scene, const std::vector<CheckSample>& samples, TimeRange range) {
  Points points;
  std::vector<uint32_t> bodies, materials;
  for (const CheckSample& sample : samples) {
    const Polygon& polygon = scene.polygons[sample.point.place.polygon];
    points.push_back(point_error(sample.solution, sample.estimates, sample.point.weight));
    bodies.push_back(body_of(scene, polygon));
    materials.push_back(polygon.material);
  }
  CheckReport report;
  report.total = estimate_error(points);
  const double whole = report.total.squared;
  report.tables.push_back(table_by("body", body_names(scene), bodies, points, whole));
  report.tables.push_back(table_by("material", material_names(scene), materials, points, whole));
  report.tables.push_back(table_by_brightness(points, whole));
  report.tables.push_back(table_by_time(samples, points, range, whole));
  report.worst = worst_of(scene, samples, points);
  return report;
}

}  // namespace strad
