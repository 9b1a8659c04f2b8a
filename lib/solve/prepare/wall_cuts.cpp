#include "solve/prepare/wall_cuts.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "light/tracer.h"
#include "scene/polygon_pieces.h"
#include "scene/trajectory.h"
#include "solution/mesh.h"
#include "solve/prepare/reach.h"
#include "time/time_grid.h"

namespace strad {
namespace {

// Fractions of the scene's diagonal: the least size of a floor, the least length and height of a wall, and
// the most thickness of a thin solid.
constexpr double kLong = 1.0 / 20, kWide = 1.0 / 50, kTall = 1.0 / 50, kThin = 1.0 / 50;
constexpr double kWhole = 0.9;  // of the floor: a contact as long as this parts it, however short it is
constexpr double kApart = 1.0 / 1000;  // contacts closer than this to an edge of the floor are not cut
constexpr double kTouching = 1e-5;
constexpr double kGap = 2e-6;  // between the two pieces, so that the mesh does not join their corners

constexpr double kLeastSine = 0.05;  // of the angle between wall and floor

// A large polygon that never moves, in world coordinates.
struct Flat {
  uint32_t polygon = 0;
  std::vector<Vec3> corners;
  Vec3 normal;
  Box box;
};

// Where a wall stands on a floor: the segment from a to b along `direction`, in world coordinates.
struct Contact {
  uint32_t floor, wall;  // polygons
  Vec3 a, b, direction;
  double lift;  // m along the floor's normal: to a height at which there is wall
};

struct Stretch {
  double begin = -1e30, end = 1e30;
};

// The part of the line at + t direction (length 1) within a convex polygon in whose plane it lies.
Stretch within(const std::vector<Vec3>& corners, Vec3 normal, Vec3 at, Vec3 direction, double tolerance) {
  Stretch in;
  for (size_t i = 0; i < corners.size(); ++i) {
    const Vec3 inward = normalized(cross(normal, corners[(i + 1) % corners.size()] - corners[i]));
    const double inside = dot(at - corners[i], inward) + tolerance, rate = dot(direction, inward);
    if (std::abs(rate) < 1e-9) {
      if (inside < 0) return {0, 0};
    } else if (rate > 0) {
      in.begin = std::max(in.begin, -inside / rate);
    } else {
      in.end = std::min(in.end, -inside / rate);
    }
  }
  return in;
}

double distance_to_edges(const std::vector<Vec3>& corners, Vec3 normal, Vec3 at) {
  double least = 1e30;
  for (size_t i = 0; i < corners.size(); ++i) {
    const Vec3 inward = normalized(cross(normal, corners[(i + 1) % corners.size()] - corners[i]));
    least = std::min(least, dot(at - corners[i], inward));
  }
  return least;
}

std::vector<Flat> large_flats(const Scene& scene, const std::vector<Pose>& poses, double diagonal) {
  const std::vector<bool> moving = moving_bodies(scene);
  std::vector<Flat> flats;
  for (uint32_t p = 0; p < scene.polygons.size(); ++p) {
    const Polygon& polygon = scene.polygons[p];
    const uint32_t body = body_of(scene, polygon);
    if (moving[body]) continue;
    Flat flat;
    flat.polygon = p;
    for (int c = 0; c < polygon.corner_count(); ++c) {
      flat.corners.push_back(poses[body] * scene.vertices[polygon.corners[c]]);
      flat.box.add(flat.corners.back());
    }
    if (flat.box.diagonal() < kWide * diagonal) continue;
    flat.normal = rotate(poses[body], polygon_normal(scene, polygon));
    flats.push_back(std::move(flat));
  }
  return flats;
}

bool apart(const Box& a, const Box& b, double tolerance) {
  for (int axis = 0; axis < 3; ++axis)
    if (a.lower[axis] > b.upper[axis] + tolerance || b.lower[axis] > a.upper[axis] + tolerance) return true;
  return false;
}

std::optional<Contact> contact_of(const Flat& floor, const Flat& wall, double diagonal) {
  const Vec3 along = cross(floor.normal, wall.normal);
  if (length(along) < kLeastSine) return std::nullopt;
  const Vec3 direction = normalized(along);
  const double cosine = dot(floor.normal, wall.normal), sine2 = 1 - cosine * cosine;
  const double of_floor = dot(floor.normal, floor.corners[0]), of_wall = dot(wall.normal, wall.corners[0]);
  const Vec3 at = ((of_floor - of_wall * cosine) / sine2) * floor.normal +
                  ((of_wall - of_floor * cosine) / sine2) * wall.normal;
  const Stretch on_floor = within(floor.corners, floor.normal, at, direction, 0);
  const Stretch on_wall = within(wall.corners, wall.normal, at, direction, kTouching * diagonal);
  const double begin = std::max(on_floor.begin, on_wall.begin), end = std::min(on_floor.end, on_wall.end);
  const double across = on_floor.end - on_floor.begin;
  if (floor.box.diagonal() < kLong * diagonal || end - begin < std::min(kWide * diagonal, kWhole * across))
    return std::nullopt;
  const Vec3 middle = at + 0.5 * (begin + end) * direction;
  if (distance_to_edges(floor.corners, floor.normal, middle) < kApart * diagonal) return std::nullopt;
  double highest = 0;
  for (const Vec3& corner : wall.corners) {
    const double height = dot(floor.normal, corner - at);
    if (std::abs(height) > std::abs(highest)) highest = height;
  }
  if (std::abs(highest) < kTall * diagonal) return std::nullopt;
  return Contact{floor.polygon,        wall.polygon, at + begin * direction,
                 at + end * direction, direction,    std::copysign(0.5 * kTall * diagonal, highest)};
}

// All contacts, ordered by floor, then by wall.
std::vector<Contact> contacts_of(std::vector<Flat> flats, double diagonal) {
  std::sort(flats.begin(), flats.end(), [](const Flat& a, const Flat& b) {
    return std::pair(a.box.lower.x, a.polygon) < std::pair(b.box.lower.x, b.polygon);
  });
  std::vector<Contact> contacts;
  const auto try_pair = [&](const Flat& floor, const Flat& wall) {
    if (const auto contact = contact_of(floor, wall, diagonal)) contacts.push_back(*contact);
  };
  for (size_t i = 0; i < flats.size(); ++i) {
    const double farthest = flats[i].box.upper.x + kTouching * diagonal;
    for (size_t j = i + 1; j < flats.size() && flats[j].box.lower.x <= farthest; ++j) {
      if (apart(flats[i].box, flats[j].box, kTouching * diagonal)) continue;
      try_pair(flats[i], flats[j]);
      try_pair(flats[j], flats[i]);
    }
  }
  std::sort(contacts.begin(), contacts.end(), [](const Contact& a, const Contact& b) {
    return std::pair(a.floor, a.wall) < std::pair(b.floor, b.wall);
  });
  return contacts;
}

// Tells walls from furniture.
class Walls {
 public:
  Walls(const Scene& scene, const std::vector<Pose>& poses, const std::vector<Contact>& contacts)
      : scene_(scene), poses_(poses), tracer_(scene) {
    for (const Contact& contact : contacts) stands_.insert({contact.floor, contact.wall});
    const TimeGrid grid = scene.end > scene.start ? make_time_grid(scene.start, scene.end, {}, 1, 64)
                                                  : instant_grid(scene.start);
    reached_ = reached_sides(scene, tracer_, grid);
  }
  bool is_wall(const Contact& contact) const {
    const bool front = reached_[2 * contact.wall], back = reached_[2 * contact.wall + 1];
    if (front == back) return front;
    // Light reaches one side only. A ray goes from just behind the surface to what lies beyond the dark. If
    // that stands on the same floor, the two are sides of a piece of furniture, unless they are close
    // together.
    const Polygon& polygon = scene_.polygons[contact.wall];
    const Pose& pose = poses_[body_of(scene_, polygon)];
    const Vec3 inward = (front ? -1.0 : 1.0) * rotate(pose, polygon_normal(scene_, polygon));
    const Vec3 up = rotate(poses_[body_of(scene_, scene_.polygons[contact.floor])],
                           polygon_normal(scene_, scene_.polygons[contact.floor]));
    const Vec3 from = 0.5 * (contact.a + contact.b) + contact.lift * up + 2 * tracer_.offset() * inward;
    const SurfaceHit hit = tracer_.closest(poses_, from, inward);
    return hit.polygon != kNone && (hit.distance < kThin * tracer_.scene_box().diagonal() ||
                                    !stands_.contains({contact.floor, hit.polygon}));
  }
  const std::vector<bool>& reached() const { return reached_; }  // see reached_sides

 private:
  const Scene& scene_;
  const std::vector<Pose>& poses_;
  const Tracer tracer_;
  std::vector<bool> reached_;
  std::set<std::pair<uint32_t, uint32_t>> stands_;  // pairs of a floor and a wall on it
};

// Cuts `piece` along the contact, but not beyond its ends.
std::vector<Piece> cut(const Piece& piece, Vec3 normal, const Contact& contact, double diagonal) {
  std::vector<Vec3> corners;
  for (const PieceCorner& corner : piece) corners.push_back(corner.position);
  const double tolerance = kTouching * diagonal;
  const Stretch in = within(corners, normal, contact.a, contact.direction, 0);
  const double end = std::min(in.end, length(contact.b - contact.a)), begin = std::max(in.begin, 0.0);
  if (end - begin < kApart * diagonal) return {piece};
  const Vec3 middle = contact.a + 0.5 * (begin + end) * contact.direction;
  if (distance_to_edges(corners, normal, middle) < kApart * diagonal) return {piece};
  std::vector<Piece> pieces;
  Piece rest = piece;
  const double from = dot(contact.direction, contact.a);
  if (begin - in.begin > kApart * diagonal) {
    Halves halves = split(rest, contact.direction, from + begin, tolerance, 0);
    pieces.push_back(std::move(halves.below));
    rest = std::move(halves.above);
  }
  if (in.end - end > kApart * diagonal) {
    Halves halves = split(rest, contact.direction, from + end, tolerance, 0);
    pieces.push_back(std::move(halves.above));
    rest = std::move(halves.below);
  }
  const Vec3 across = cross(normal, contact.direction);
  Halves halves = split(rest, across, dot(across, contact.a), tolerance, kGap * diagonal);
  pieces.push_back(std::move(halves.below));
  pieces.push_back(std::move(halves.above));
  std::erase_if(pieces, [](const Piece& p) { return p.size() < 3; });
  return pieces;
}

}  // namespace

CutScene cut_under_walls(Scene scene) {
  Box box;
  for (const Vec3& vertex : scene.vertices) box.add(vertex);
  const double diagonal = box.diagonal();
  const std::vector<Pose> poses = poses_at(scene, scene.start);
  std::vector<Contact> contacts = contacts_of(large_flats(scene, poses, diagonal), diagonal);
  if (contacts.empty()) return {std::move(scene), {}};
  std::vector<bool> reached;
  {
    const Walls walls(scene, poses, contacts);
    std::erase_if(contacts, [&](const Contact& contact) { return !walls.is_wall(contact); });
    reached = walls.reached();
  }
  std::vector<Polygon> polygons;
  std::vector<bool> dark;
  const auto keep_dark = [&](uint32_t uncut, size_t count) {
    for (size_t i = 0; i < count; ++i) {
      dark.push_back(!reached[2 * uncut]);
      dark.push_back(!reached[2 * uncut + 1]);
    }
  };
  auto contact = contacts.begin();  // in order of floors
  for (uint32_t p = 0; p < scene.polygons.size(); ++p) {
    const Polygon polygon = scene.polygons[p];
    if (contact == contacts.end() || contact->floor != p) {
      polygons.push_back(polygon);
      keep_dark(p, 1);
      continue;
    }
    const Pose& pose = poses[body_of(scene, polygon)];
    const Pose back = inverse(pose);
    const Vec3 normal = polygon_normal(scene, polygon);
    std::vector<Piece> pieces{uncut_piece(scene, polygon)};
    for (; contact != contacts.end() && contact->floor == p; ++contact) {
      Contact at_rest = *contact;
      at_rest.a = back * at_rest.a;
      at_rest.b = back * at_rest.b;
      at_rest.direction = rotate(back, at_rest.direction);
      std::vector<Piece> next;
      for (const Piece& piece : pieces)
        for (Piece& part : cut(piece, normal, at_rest, diagonal)) next.push_back(std::move(part));
      pieces = std::move(next);
    }
    const std::vector<Polygon> parts = polygons_of(pieces, polygon, &scene);
    polygons.insert(polygons.end(), parts.begin(), parts.end());
    keep_dark(p, parts.size());
  }
  scene.polygons = std::move(polygons);
  return {std::move(scene), std::move(dark)};
}

}  // namespace strad
