#include "import/pov/csg.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "import/polygonize.h"
#include "import/pov/corner_weights.h"
#include "import/pov/shapes.h"
#include "import/pov/solids.h"

namespace strad {
namespace {

constexpr double kTouch = 1e-9;  // of the size of what is cut

// Points that are made where surfaces cut each other, each once: two surfaces find the same point but for
// rounding.
class Welder {
 public:
  Welder(std::vector<Vec3>* points, double tolerance) : points_(points), cell_(4 * tolerance) {}
  uint32_t index(Vec3 p) {
    const std::array<int64_t, 3> at{cell(p.x), cell(p.y), cell(p.z)};
    for (int64_t dx = -1; dx <= 1; ++dx)
      for (int64_t dy = -1; dy <= 1; ++dy)
        for (int64_t dz = -1; dz <= 1; ++dz) {
          const auto found = known_.find({at[0] + dx, at[1] + dy, at[2] + dz});
          if (found != known_.end() && length((*points_)[found->second] - p) <= cell_ / 4)
            return found->second;
        }
    points_->push_back(p);
    return known_[at] = static_cast<uint32_t>(points_->size() - 1);
  }

 private:
  int64_t cell(double x) const { return static_cast<int64_t>(std::floor(x / cell_)); }
  std::vector<Vec3>* points_;
  double cell_;
  std::map<std::array<int64_t, 3>, uint32_t> known_;
};

double largest(const Box& box) {
  double size = 0;
  if (box.empty()) return size;
  for (int axis = 0; axis < 3; ++axis)
    size = std::max({size, std::abs(box.lower[axis]), std::abs(box.upper[axis])});
  return size;
}

// Cuts facets one by one and collects what is left of them.
class Cutter {
 public:
  // `size`: of all that is finite; `room`: the largest coordinate of all.
  Cutter(PovCut* made, double size, double room)
      : made_(made), touch_(kTouch * (size > 0 ? size : 1)), room_(room), welder_(&made->points, touch_) {}

  // The facets that follow are those of an object, from `facet` on.
  void begin(uint32_t object, uint32_t facet = 0) { object_ = object, facet_ = facet; }

  // `cut`: takes the region of the facet, and what is needed to cut it, and returns what is left of it.
  template <typename Cut>
  void add(const PovFacet& facet, const PovObject& of, Cut cut) {
    add_what_is_left(facet, of, cut);
    made_->sources.resize(made_->facets.size(), {object_, facet_++});
  }

 private:
  template <typename Cut>
  void add_what_is_left(const PovFacet& facet, const PovObject& of, Cut& cut) {
    std::vector<Vec3> outline;
    Box around;
    for (const uint32_t corner : facet.corners)
      outline.push_back(of.points[corner]), around.add(outline.back());
    const Vec3 normal = normalized(doubled_area_of(outline));
    if (!(length(normal) > 0)) return;
    around.add(around.lower - Vec3{touch_, touch_, touch_});
    around.add(around.upper + Vec3{touch_, touch_, touch_});
    // The point of the plane that is nearest to the origin: what is near it has exact coordinates.
    const PovSheet sheet{dot(outline[0], normal) * normal, frame_about(normal), 2 * room_ / kSheetSteps,
                         touch_};
    Ring ring;
    std::map<RingPoint, uint32_t> corners;
    for (size_t k = 0; k < outline.size(); ++k) {
      ring.push_back(sheet.grid(outline[k]));
      corners.insert({ring.back(), facet.corners[k]});
    }
    const RingSet left = cut(RingSet{ring}, sheet, around);
    // What is narrower than what counts as touching is nothing.
    const auto is_sliver = [&](double area, const Ring& of_ring) {
      return !(std::abs(area) > touch_ / sheet.step * perimeter(of_ring));
    };
    const double whole = doubled_area({ring});
    if (left.size() == 1 && is_sliver(whole - doubled_area(left), ring)) return keep(facet, of);
    std::vector<std::vector<Vec3>> rings;
    for (const Ring& piece : left) {
      if (piece.size() < 3 || is_sliver(doubled_area({piece}), piece)) continue;
      std::vector<Vec3>& to = rings.emplace_back();
      for (const RingPoint at : piece) {
        const auto corner = corners.find(at);
        to.push_back(corner != corners.end() ? of.points[corner->second] : sheet.point(at));
      }
    }
    if (!rings.empty()) add_rings(rings, {outline, normal}, facet, of);
  }

  static Vec3 doubled_area_of(const std::vector<Vec3>& outline) {
    return strad::doubled_area(std::span<const Vec3>(outline));
  }
  static double doubled_area(const RingSet& rings) { return strad::doubled_area(rings); }

  static double perimeter(const Ring& ring) {
    double sum = 0;
    for (size_t i = 0; i < ring.size(); ++i) {
      const RingPoint &p = ring[i], &q = ring[(i + 1) % ring.size()];
      sum += std::hypot(static_cast<double>(q[0] - p[0]), static_cast<double>(q[1] - p[1]));
    }
    return sum;
  }

  void keep(const PovFacet& facet, const PovObject& of) {
    PovFacet whole = facet;
    whole.surface = nullptr;
    for (uint32_t& corner : whole.corners) corner = welder_.index(of.points[corner]);
    const auto first_uv = static_cast<uint32_t>(made_->uvs.size());
    for (size_t k = 0; k < whole.uvs.size(); ++k) {
      made_->uvs.push_back(of.uvs[whole.uvs[k]]);
      whole.uvs[k] = first_uv + static_cast<uint32_t>(k);
    }
    made_->facets.push_back(std::move(whole));
  }

  struct Outline {
    const std::vector<Vec3>& corners;
    Vec3 normal;  // unit
  };

  // What is left of `facet`. Normals and texture coordinates at new corners lie between those that it has.
  void add_rings(const std::vector<std::vector<Vec3>>& rings, const Outline& outline, const PovFacet& facet,
                 const PovObject& of) {
    const PovObject pieces = pov_oriented_polygon(rings, outline.normal);
    for (const PovFacet& piece : pieces.facets) {
      PovFacet part;
      part.part = facet.part;
      for (const uint32_t corner : piece.corners) {
        const uint32_t index = welder_.index(pieces.points[corner]);
        if (!part.corners.empty() && (part.corners.back() == index)) continue;
        part.corners.push_back(index);
        add_between(facet, of, corner_weights_of(facet, outline, pieces.points[corner]), &part);
      }
      while (part.corners.size() > 1 && part.corners.front() == part.corners.back()) {
        part.corners.pop_back();
        if (!part.normals.empty()) part.normals.pop_back();
        if (!part.uvs.empty()) part.uvs.pop_back();
      }
      if (part.corners.size() >= 3) made_->facets.push_back(std::move(part));
    }
  }

  static std::vector<double> corner_weights_of(const PovFacet& facet, const Outline& outline, Vec3 point) {
    if (facet.normals.empty() && facet.uvs.empty()) return {};
    return corner_weights(outline.corners, outline.normal, point);
  }

  void add_between(const PovFacet& facet, const PovObject& of, const std::vector<double>& weights,
                   PovFacet* part) {
    if (!facet.normals.empty()) {
      Vec3 normal;
      for (size_t k = 0; k < weights.size(); ++k) normal += weights[k] * normalized(facet.normals[k]);
      part->normals.push_back(normal);
    }
    if (!facet.uvs.empty()) {
      Vec2 uv;
      for (size_t k = 0; k < weights.size(); ++k) {
        uv.x += weights[k] * of.uvs[facet.uvs[k]].x;
        uv.y += weights[k] * of.uvs[facet.uvs[k]].y;
      }
      part->uvs.push_back(static_cast<uint32_t>(made_->uvs.size()));
      made_->uvs.push_back(uv);
    }
  }

  PovCut* made_;
  uint32_t object_ = 0, facet_ = 0;
  double touch_, room_;
  Welder welder_;
};

// What a cut takes over from the objects that it is made of.
void take_rest(PovObject* made, const PovObject& from) {
  made->lights.insert(made->lights.end(), from.lights.begin(), from.lights.end());
  made->problems.insert(made->problems.end(), from.problems.begin(), from.problems.end());
  made->notes.insert(made->notes.end(), from.notes.begin(), from.notes.end());
}

double reach_of(const PovObject& object) {
  Box box;
  for (const Vec3 p : object.points) box.add(p);
  return largest(box);
}

// The part of a region that has the solid behind it and not before it.
RingSet boundary_part(const RingSet& region, const PovSolid& solid, const PovSheet& sheet,
                      const Box& around) {
  const RingSet behind = part_inside(region, solid, sheet, PovSide::kBelow, around);
  const RingSet before = part_inside(region, solid, sheet, PovSide::kAbove, around);
  return before.empty() || behind.empty() ? behind : combined(RingOperation::kFirstAlone, behind, before);
}

bool reaches_far(const PovObject& object) { return reach_of(object) > kEndless / 4; }

// What is left of the surfaces of objects where all others are.
PovCut common_surface(std::span<const PovObject> objects, std::span<const PovSolid>) {
  PovCut cut;
  double size = 0, room = 1e-3;
  std::vector<PovSolid> solids;
  for (const PovObject& object : objects) {
    solids.push_back(settled(object.solid));
    const double reach = reach_of(object), hulls = largest(box_of_hulls(solids.back()));
    size = std::max({size, hulls, object.endless ? 0 : reach});
    room = std::max({room, hulls, reach});
  }
  Cutter cutter(&cut, size, room);
  for (size_t i = 0; i < objects.size(); ++i) {
    cutter.begin(static_cast<uint32_t>(i));
    for (const PovFacet& facet : objects[i].facets) {
      cutter.add(facet, objects[i], [&](RingSet region, const PovSheet& sheet, const Box& around) {
        // Surfaces of a union that lie inside it do not bound it.
        if (solids[i].kind == PovSolid::kUnion && solids[i].parts.size() > 1)
          region = boundary_part(region, solids[i], sheet, around);
        for (size_t j = 0; j < objects.size(); ++j) {
          if (j == i) continue;
          // Just behind the facet must be inside all others. Where the surface of another lies in the same
          // plane and faces the same way, it is the first one's: before it is outside the first.
          region = part_inside(region, solids[j], sheet, PovSide::kBelow, around);
          if (j < i) region = part_inside(region, solids[j], sheet, PovSide::kAbove, around);
        }
        return region;
      });
    }
  }
  return cut;
}

// What is left of an object's surface inside all solids.
PovCut clipped_surface(std::span<const PovObject> objects, std::span<const PovSolid> clips) {
  const PovObject& object = objects[0];
  PovCut cut;
  std::vector<PovSolid> solids;
  double size = object.endless ? 0 : reach_of(object), room = std::max(1e-3, reach_of(object));
  for (const PovSolid& clip : clips) {
    solids.push_back(settled(clip));
    size = std::max(size, largest(box_of_hulls(solids.back())));
  }
  Cutter cutter(&cut, size, std::max(room, size));
  cutter.begin(0);
  for (const PovFacet& facet : object.facets)
    cutter.add(facet, object, [&](RingSet region, const PovSheet& sheet, const Box& around) {
      for (const PovSolid& solid : solids) {
        // A facet that lies in a side of what clips it, which is common, counts as inside.
        RingSet above = part_inside(region, solid, sheet, PovSide::kAbove, around);
        region = part_inside(region, solid, sheet, PovSide::kBelow, around);
        if (region.empty() || above.empty())
          region = region.empty() ? std::move(above) : region;
        else
          region = combined(RingOperation::kEither, region, above);
      }
      return region;
    });
  return cut;
}

using MakeCut = PovCut (*)(std::span<const PovObject>, std::span<const PovSolid>);
std::shared_ptr<const PovCut> cached_cut(PovCutCache* cache, std::span<const PovObject> objects,
                                         std::span<const PovSolid> solids, MakeCut make) {
  if (!cache) return std::make_shared<const PovCut>(make(objects, solids));
  const PovCutCache::Key key = PovCutCache::key_of(objects, solids);
  std::shared_ptr<const PovCut> cut = cache->find(key);
  if (!cut) cache->keep(key, cut = std::make_shared<const PovCut>(make(objects, solids)));
  return cut;
}

// Makes the facets of a cut those of `made`, with the surfaces of those that they come from.
void take_cut(const PovCut& cut, std::span<const PovObject> objects, PovObject* made) {
  made->points = cut.points;
  made->uvs = cut.uvs;
  made->facets = cut.facets;
  for (size_t i = 0; i < cut.facets.size(); ++i) {
    const PovFacet& source = objects[cut.sources[i].first].facets[cut.sources[i].second];
    made->facets[i].surface = source.surface;
    made->facets[i].no_shadow = source.no_shadow;
  }
}

}  // namespace

PovObject pov_inverse(PovObject object) {
  object.solid.inverse = !object.solid.inverse;
  for (PovFacet& facet : object.facets) {
    std::reverse(facet.corners.begin(), facet.corners.end());
    std::reverse(facet.uvs.begin(), facet.uvs.end());
    std::reverse(facet.normals.begin(), facet.normals.end());
    for (Vec3& normal : facet.normals) normal = -normal;
  }
  return object;
}

PovObject pov_intersection(std::vector<PovObject> objects, PovCutCache* cache) {
  PovObject made;
  made.compound = true;
  for (const PovObject& object : objects) {
    take_rest(&made, object);
    made.endless = made.endless || object.endless;
  }
  take_cut(*cached_cut(cache, objects, {}, common_surface), objects, &made);
  for (PovFacet& facet : made.facets) facet.part = 0;
  std::vector<PovSolid> parts;
  for (PovObject& object : objects) parts.push_back(std::move(object.solid));
  made.solid = solid_of(PovSolid::kIntersection, std::move(parts));
  made.endless = made.endless && reaches_far(made);
  return made;
}

void pov_clip(PovObject* object, const std::vector<PovSolid>& clips, PovCutCache* cache) {
  PovObject made = *object;
  made.shapes = {0};
  const std::span<const PovObject> objects(object, 1);
  take_cut(*cached_cut(cache, objects, clips, clipped_surface), objects, &made);
  std::vector<PovSolid> parts{object->solid};
  parts.insert(parts.end(), clips.begin(), clips.end());
  made.solid = solid_of(PovSolid::kIntersection, std::move(parts));
  made.endless = object->endless && reaches_far(made);
  *object = std::move(made);
}

void pov_cut_endless(PovObject* object, Vec3 centre, double size, double reach) {
  PovObject made = *object;
  made.shapes.clear();
  const double room = std::max(reach_of(*object), largest(Box{centre, centre}));
  size_t next = 0;  // facet: they come in the order of the shapes
  PovCut cut;
  for (size_t shape = 0; shape < object->shapes.size(); ++shape) {
    made.shapes.push_back(static_cast<uint32_t>(cut.points.size()));
    const uint32_t end = shape + 1 < object->shapes.size() ? object->shapes[shape + 1] : ~uint32_t{0};
    Cutter cutter(&cut, size, room);
    cutter.begin(0, static_cast<uint32_t>(next));
    for (; next < object->facets.size() && object->facets[next].corners[0] < end; ++next) {
      const PovFacet& facet = object->facets[next];
      std::vector<Vec3> outline;
      for (const uint32_t corner : facet.corners) outline.push_back(object->points[corner]);
      const Vec3 normal = normalized(doubled_area(std::span<const Vec3>(outline)));
      const double half = reach * std::max(size, std::abs(dot(centre - outline[0], normal)));
      const Vec3 corner{half, half, half};
      const PovSolid box = settled(solid_of_facets(pov_box(centre - corner, centre + corner)));
      cutter.add(facet, *object, [&](const RingSet& region, const PovSheet& sheet, const Box& around) {
        return part_inside(region, box, sheet, PovSide::kBelow, around);
      });
    }
  }
  take_cut(cut, std::span<const PovObject>(object, 1), &made);
  made.endless = false;
  *object = std::move(made);
}

}  // namespace strad
