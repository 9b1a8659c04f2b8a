#include "import/pov/turned.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "import/pov/shapes.h"
#include "import/pov/solids.h"

namespace strad {
namespace {

Vec2 mix(const std::vector<Vec2>& p, size_t first, std::initializer_list<double> weights) {
  Vec2 sum;
  for (const double w : weights) sum.x += w * p[first].x, sum.y += w * p[first].y, ++first;
  return sum;
}

// A profile that ends away from where it begins is closed along the axis.
double area_of(const std::vector<Vec2>& profile) {
  double sum = 0;
  const auto add = [&sum](Vec2 a, Vec2 b) { sum += cross2(a, b); };
  for (size_t i = 0; i + 1 < profile.size(); ++i) add(profile[i], profile[i + 1]);
  const Vec2 first = profile.front(), last = profile.back();
  if (first == last) return sum;
  add(last, {0, last.y});
  add({0, first.y}, first);
  return sum;
}

void add_quad(PovObject* object, std::vector<uint32_t> corners) {
  PovFacet facet;
  facet.corners = std::move(corners);
  object->facets.push_back(std::move(facet));
}

// Distance of a superellipse |x|^(2/e) + |y|^(2/e) = 1 from its centre, at an angle.
Vec2 superellipse(double exponent, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double sum = std::pow(std::abs(c), 2 / exponent) + std::pow(std::abs(s), 2 / exponent);
  const double r = std::pow(sum, -exponent / 2);
  return {r * c, r * s};
}

}  // namespace

std::vector<Vec2> pov_curve(const std::string& kind, const std::vector<Vec2>& controls, int steps) {
  if (kind == "linear_spline") return controls;
  const size_t ahead = kind == "quadratic_spline" ? 3 : 4, stride = kind == "bezier_spline" ? 4 : 1;
  std::vector<Vec2> points;
  for (size_t i = 0; i + ahead <= controls.size(); i += stride) {
    for (int k = points.empty() ? 0 : 1; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps, t2 = t * t, t3 = t2 * t, u = 1 - t;
      if (kind == "quadratic_spline") {
        points.push_back(mix(controls, i, {t2 / 2 - t / 2, 1 - t2, t2 / 2 + t / 2}));
      } else if (kind == "cubic_spline") {  // Catmull & Rom 1974
        points.push_back(
            mix(controls, i,
                {-t / 2 + t2 - t3 / 2, 1 - 2.5 * t2 + 1.5 * t3, t / 2 + 2 * t2 - 1.5 * t3, t3 / 2 - t2 / 2}));
      } else {
        points.push_back(mix(controls, i, {u * u * u, 3 * t * u * u, 3 * t2 * u, t3}));
      }
    }
  }
  return points;
}

PovObject pov_turned(std::vector<Vec2> profile, int sides) {
  PovObject object;
  double widest = 0;
  for (Vec2& p : profile) p.x = std::abs(p.x), widest = std::max(widest, p.x);
  for (Vec2& p : profile)
    if (p.x < 1e-9 * widest) p.x = 0;
  if (area_of(profile) < 0) std::reverse(profile.begin(), profile.end());
  const bool closed = profile.front() == profile.back();
  std::vector<uint32_t> rings;
  for (size_t i = 0; i < profile.size(); ++i) {
    if (closed && i + 1 == profile.size()) {
      rings.push_back(rings.front());
      break;
    }
    rings.push_back(static_cast<uint32_t>(object.points.size()));
    for (int k = 0; k < (profile[i].x > 0 ? sides : 1); ++k) {
      const double angle = 2 * kPi * k / sides;
      object.points.push_back(
          {profile[i].x * std::cos(angle), profile[i].y, -profile[i].x * std::sin(angle)});
    }
  }
  for (size_t i = 0; i + 1 < profile.size(); ++i) {
    const bool low = profile[i].x > 0, high = profile[i + 1].x > 0;
    if (profile[i] == profile[i + 1] || (!low && !high)) continue;
    for (int k = 0; k < sides; ++k) {
      const auto a = static_cast<uint32_t>(k), b = static_cast<uint32_t>((k + 1) % sides);
      if (low && high)
        add_quad(&object, {rings[i] + a, rings[i] + b, rings[i + 1] + b, rings[i + 1] + a});
      else if (low)
        add_quad(&object, {rings[i] + a, rings[i] + b, rings[i + 1]});
      else
        add_quad(&object, {rings[i], rings[i + 1] + b, rings[i + 1] + a});
    }
  }
  object.solid = solid_of_facets(object);
  return object;
}

PovObject pov_torus(double major, double minor, int sides) {
  std::vector<Vec2> circle;
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * kPi * k / sides;
    circle.push_back({major + minor * std::cos(angle), minor * std::sin(angle)});
  }
  circle.push_back(circle.front());
  return pov_turned(circle, sides);
}

// Between two points the square of the radius is a cubic of the height (POV-Ray's documentation of sor).
PovObject pov_sor(const std::vector<Vec2>& p, int sides, bool open) {
  const int steps = std::max(2, sides / 4);
  std::vector<Vec2> profile;
  const auto slope = [&p](size_t i) {
    return 2 * p[i].x * (p[i + 1].x - p[i - 1].x) / (p[i + 1].y - p[i - 1].y);
  };
  for (size_t i = 1; i + 2 < p.size(); ++i) {
    const double h = p[i + 1].y - p[i].y, from = h * slope(i), to = h * slope(i + 1);
    for (int k = profile.empty() ? 0 : 1; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps, t2 = t * t, t3 = t2 * t;
      const double square = (2 * t3 - 3 * t2 + 1) * p[i].x * p[i].x +
                            (3 * t2 - 2 * t3) * p[i + 1].x * p[i + 1].x + (t3 - 2 * t2 + t) * from +
                            (t3 - t2) * to;
      profile.push_back({std::sqrt(std::max(0.0, square)), p[i].y + t * h});
    }
  }
  if (!open) {
    profile.insert(profile.begin(), {0, profile.front().y});
    profile.push_back({0, profile.back().y});
  }
  return pov_turned(profile, sides);
}

PovObject pov_superellipsoid(double east, double north, int sides) {
  PovObject object;
  const int around = (sides + 7) / 8 * 8,
            bands = std::max(4, around / 2);  // corners lie at multiples of 45 degrees
  std::vector<uint32_t> rings;
  for (int band = 0; band <= bands; ++band) {
    const Vec2 at = superellipse(north, kPi * band / bands - kPi / 2);
    const bool pole = band == 0 || band == bands;
    rings.push_back(static_cast<uint32_t>(object.points.size()));
    for (int k = 0; k < (pole ? 1 : around); ++k) {
      const Vec2 ring = superellipse(east, 2 * kPi * k / around);
      const double r = pole ? 0 : at.x;
      object.points.push_back({r * ring.x, r * ring.y, pole ? (band ? 1.0 : -1.0) : at.y});
    }
  }
  for (int band = 0; band < bands; ++band) {
    const uint32_t low = rings[static_cast<size_t>(band)], high = rings[static_cast<size_t>(band) + 1];
    for (int k = 0; k < around; ++k) {
      const auto a = static_cast<uint32_t>(k), b = static_cast<uint32_t>((k + 1) % around);
      if (band == 0)
        add_quad(&object, {low, high + b, high + a});
      else if (band + 1 == bands)
        add_quad(&object, {low + a, low + b, high});
      else
        add_quad(&object, {low + a, low + b, high + b, high + a});
    }
  }
  object.solid = solid_of_facets(object);
  return object;
}

PovObject pov_drawn(const std::vector<std::vector<Vec3>>& from, const std::vector<std::vector<Vec3>>& to,
                    bool open) {
  PovObject object = pov_polygon(to);
  const auto count = static_cast<uint32_t>(object.points.size());
  Vec3 up;
  std::vector<Vec3> outline;
  for (const uint32_t corner : object.facets.empty() ? std::vector<uint32_t>{} : object.facets[0].corners)
    outline.push_back(object.points[corner]);
  for (size_t i = 2; i < outline.size(); ++i)
    up += cross(outline[i - 1] - outline[0], outline[i] - outline[0]);
  if (dot(up, to[0][0] - from[0][0]) < 0)
    for (PovFacet& facet : object.facets) std::reverse(facet.corners.begin(), facet.corners.end());
  for (const std::vector<Vec3>& ring : from)
    object.points.insert(object.points.end(), ring.begin(), ring.end());
  // Edges that are followed one way only are those of the rings; the others are bridges to holes.
  std::set<std::pair<uint32_t, uint32_t>> edges;
  const size_t lids = object.facets.size();
  for (const PovFacet& facet : object.facets)
    for (size_t k = 0; k < facet.corners.size(); ++k)
      edges.insert({facet.corners[k], facet.corners[(k + 1) % facet.corners.size()]});
  for (size_t i = 0; i < lids; ++i) {
    std::vector<uint32_t> below;
    for (const uint32_t corner : object.facets[i].corners) below.push_back(corner + count);
    std::reverse(below.begin(), below.end());
    add_quad(&object, std::move(below));
  }
  for (const auto& [a, b] : edges)
    if (a != b && !edges.contains({b, a})) add_quad(&object, {a + count, b + count, b, a});
  object.solid = solid_of_facets(object);
  if (open)
    object.facets.erase(object.facets.begin(), object.facets.begin() + static_cast<std::ptrdiff_t>(2 * lids));
  return object;
}

}  // namespace strad
