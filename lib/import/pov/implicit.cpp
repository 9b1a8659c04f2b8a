#include "import/pov/implicit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "import/pov/shapes.h"
#include "import/pov/solids.h"

namespace strad {
namespace {

double longest_side(const Box& box) {
  const Vec3 size = box.upper - box.lower;
  return std::max({size.x, size.y, size.z});
}

// Values at the corners of a grid. Those on the rim count as outside, so that the surface is closed.
class Grid {
 public:
  Grid(const PovField& field, const Box& box, int cells) : field_(field), box_(box) {
    const Vec3 size = box.upper - box.lower;
    const double cell = longest_side(box) / cells;
    for (int axis = 0; axis < 3; ++axis)
      counts_[static_cast<size_t>(axis)] = std::max(2, static_cast<int>(std::ceil(size[axis] / cell))) + 1;
    values_.resize(static_cast<size_t>(counts_[0]) * static_cast<size_t>(counts_[1]) *
                   static_cast<size_t>(counts_[2]));
    for (int z = 0; z < counts_[2]; ++z)
      for (int y = 0; y < counts_[1]; ++y)
        for (int x = 0; x < counts_[0]; ++x) {
          const double value = field(at(x, y, z));
          const bool rim =
              x == 0 || y == 0 || z == 0 || x + 1 == counts_[0] || y + 1 == counts_[1] || z + 1 == counts_[2];
          leaves_ = leaves_ || (rim && value < 0);
          values_[index(x, y, z)] = rim ? std::max(value, 0.0) : value;
        }
  }
  int count(size_t axis) const { return counts_[axis]; }
  bool leaves() const { return leaves_; }  // the inside reaches the rim
  uint32_t index(int x, int y, int z) const {
    return static_cast<uint32_t>((z * counts_[1] + y) * counts_[0] + x);
  }
  bool inside(uint32_t corner) const { return values_[corner] < 0; }
  Vec3 at(uint32_t corner) const {
    const auto nx = static_cast<uint32_t>(counts_[0]), ny = static_cast<uint32_t>(counts_[1]);
    return at(static_cast<int>(corner % nx), static_cast<int>(corner / nx % ny),
              static_cast<int>(corner / nx / ny));
  }
  // Where the surface crosses an edge: by bisection, from the inside to the outside.
  Vec3 crossing(uint32_t inner, uint32_t outer) const {
    constexpr int kHalvings = 20;
    Vec3 a = at(inner), b = at(outer);
    if (!(field_(b) >= 0)) return b;  // on the rim
    for (int i = 0; i < kHalvings; ++i) {
      const Vec3 middle = lerp(a, b, 0.5);
      (field_(middle) < 0 ? a : b) = middle;
    }
    return lerp(a, b, 0.5);
  }

 private:
  Vec3 at(int x, int y, int z) const {
    const Vec3 size = box_.upper - box_.lower;
    return box_.lower +
           Vec3{size.x * x / (counts_[0] - 1), size.y * y / (counts_[1] - 1), size.z * z / (counts_[2] - 1)};
  }
  const PovField& field_;
  Box box_;
  std::array<int, 3> counts_{};
  std::vector<double> values_;
  bool leaves_ = false;
};

// Surface nets (Gibson 1998): a point in each cell that the surface crosses, the mean of where it crosses the
// cell's edges; and for each crossed edge of the grid a quad between the points of the four cells around it.
class Nets {
 public:
  explicit Nets(const Grid& grid) : grid_(grid) {}
  PovObject object() {
    for (int z = 1; z + 1 < grid_.count(2); ++z)
      for (int y = 1; y + 1 < grid_.count(1); ++y)
        for (int x = 1; x + 1 < grid_.count(0); ++x)
          for (int axis = 0; axis < 3; ++axis) edge(x, y, z, axis);
    // Edges that begin on the rim and end inside.
    for (int z = 0; z + 1 < grid_.count(2); ++z)
      for (int y = 0; y + 1 < grid_.count(1); ++y)
        for (int x = 0; x + 1 < grid_.count(0); ++x) {
          if (x == 0 && y > 0 && z > 0) edge(x, y, z, 0);
          if (y == 0 && x > 0 && z > 0) edge(x, y, z, 1);
          if (z == 0 && x > 0 && y > 0) edge(x, y, z, 2);
        }
    object_.solid = solid_of_facets(object_);
    return std::move(object_);
  }

 private:
  void edge(int x, int y, int z, int axis) {
    const uint32_t from = grid_.index(x, y, z),
                   to = grid_.index(x + (axis == 0), y + (axis == 1), z + (axis == 2));
    if (grid_.inside(from) == grid_.inside(to)) return;
    std::array<int, 3> u{}, v{};
    u[static_cast<size_t>((axis + 1) % 3)] = 1;
    v[static_cast<size_t>((axis + 2) % 3)] = 1;
    std::array<uint32_t, 4> cells{};  // counter-clockwise seen against the axis
    const std::array<std::array<int, 2>, 4> around{{{1, 1}, {0, 1}, {0, 0}, {1, 0}}};
    for (size_t k = 0; k < 4; ++k)
      cells[k] =
          cell(x - around[k][0] * u[0] - around[k][1] * v[0], y - around[k][0] * u[1] - around[k][1] * v[1],
               z - around[k][0] * u[2] - around[k][1] * v[2]);
    if (grid_.inside(to)) std::reverse(cells.begin(), cells.end());
    triangle(cells[0], cells[1], cells[2]);
    triangle(cells[0], cells[2], cells[3]);
  }
  void triangle(uint32_t a, uint32_t b, uint32_t c) {
    PovFacet facet;
    facet.corners = {a, b, c};
    object_.facets.push_back(std::move(facet));
  }
  // The point of a cell.
  uint32_t cell(int x, int y, int z) {
    const auto [known, is_new] =
        points_.insert({grid_.index(x, y, z), static_cast<uint32_t>(object_.points.size())});
    if (!is_new) return known->second;
    Vec3 sum;
    int count = 0;
    for (int corner = 0; corner < 8; ++corner) {
      for (int axis = 0; axis < 3; ++axis) {
        if (corner >> axis & 1) continue;
        const int other = corner | 1 << axis;
        const auto of = [&](int c) { return grid_.index(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2 & 1)); };
        const uint32_t a = of(corner), b = of(other);
        if (grid_.inside(a) == grid_.inside(b)) continue;
        sum += grid_.inside(a) ? grid_.crossing(a, b) : grid_.crossing(b, a);
        ++count;
      }
    }
    object_.points.push_back(sum / count);
    return known->second;
  }

  const Grid& grid_;
  std::map<uint32_t, uint32_t> points_;
  PovObject object_;
};

}  // namespace

PovObject pov_implicit(const PovField& field, const Box& box, int cells) {
  // A rim of a cell around what is asked for.
  const double margin = longest_side(box) / cells;
  Box wider = box;
  wider.add(box.lower - Vec3{margin, margin, margin});
  wider.add(box.upper + Vec3{margin, margin, margin});
  const auto bounded = [&](Vec3 p) {
    double beyond = -std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
      beyond = std::max({beyond, box.lower[axis] - p[axis], p[axis] - box.upper[axis]});
    return beyond > 0 ? beyond : std::max(field(p), beyond);
  };
  if (!(longest_side(wider) > 0)) return {};  // a point
  const PovField inside = bounded;
  const Grid grid(inside, wider, cells + 2);
  return Nets(grid).object();
}

std::optional<Box> box_of_field(const PovField& field, double reach) {
  constexpr int kCells = 48;
  Box box;
  box.add(Vec3{-reach, -reach, -reach});
  box.add(Vec3{reach, reach, reach});
  const Grid grid(field, box, kCells);
  if (grid.leaves()) return {};
  Box found;
  const double cell = 2 * reach / kCells;
  for (int z = 0; z < grid.count(2); ++z)
    for (int y = 0; y < grid.count(1); ++y)
      for (int x = 0; x < grid.count(0); ++x)
        if (const uint32_t corner = grid.index(x, y, z); grid.inside(corner)) {
          found.add(grid.at(corner) - Vec3{cell, cell, cell});
          found.add(grid.at(corner) + Vec3{cell, cell, cell});
        }
  if (found.empty()) return {};
  return found;
}

void pov_make_pending(PovObject* object, const std::optional<Box>& box, int cells) {
  if (!object->pending) return;
  const PovPending pending = std::move(*object->pending);
  object->pending.reset();
  std::optional<Box> domain;
  if (box && !box->empty()) {
    const PovTransform back = inverse_of(pending.placed);
    domain.emplace();
    for (int corner = 0; corner < 8; ++corner)
      domain->add(
          back.point({corner & 1 ? box->upper.x : box->lower.x, corner & 2 ? box->upper.y : box->lower.y,
                      corner & 4 ? box->upper.z : box->lower.z}));
  }
  // Small ones first: the grid that finds them is coarse.
  for (const double reach : {4.0, 40.0})
    if (!domain) domain = box_of_field(pending.field, reach);
  if (!domain) {
    object->problems.push_back({pending.kind + " without bounds", object->place});
    return;
  }
  PovObject made = pov_implicit(pending.field, *domain, cells);
  move_object(&made, pending.placed);
  object->points = std::move(made.points);
  object->facets = std::move(made.facets);
  object->solid = std::move(made.solid);
}

}  // namespace strad
