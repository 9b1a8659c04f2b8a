#include "scene/polygon_pieces.h"

#include <algorithm>

namespace strad {
namespace {

Vec3 as_kept(Vec3 p) { return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}; }

PieceCorner between(const PieceCorner& a, const PieceCorner& b, double s) {
  return {lerp(a.position, b.position, s), {a.uv.x + s * (b.uv.x - a.uv.x), a.uv.y + s * (b.uv.y - a.uv.y)}};
}

PieceCorner moved(PieceCorner corner, Vec3 by) {
  corner.position += by;
  return corner;
}

}  // namespace

Piece uncut_piece(const Scene& scene, const Polygon& polygon) {
  Piece piece;
  for (int c = 0; c < polygon.corner_count(); ++c) {
    const uint32_t uv = polygon.uvs[c];
    piece.push_back({scene.vertices[polygon.corners[c]], uv == kNone ? Vec2{} : scene.uvs[uv]});
  }
  return piece;
}

Halves split(const Piece& piece, Vec3 normal, double offset, double tolerance, double gap) {
  Halves halves;
  for (size_t i = 0; i < piece.size(); ++i) {
    const PieceCorner &a = piece[i], &b = piece[(i + 1) % piece.size()];
    const double at_a = dot(normal, a.position) - offset, at_b = dot(normal, b.position) - offset;
    const bool on = std::abs(at_a) <= tolerance;
    if (on || at_a < 0) halves.below.push_back(on ? moved(a, (-gap - at_a) * normal) : a);
    if (on || at_a > 0) halves.above.push_back(on ? moved(a, (gap - at_a) * normal) : a);
    if (on || std::abs(at_b) <= tolerance || (at_a < 0) == (at_b < 0)) continue;
    const PieceCorner cut = between(a, b, at_a / (at_a - at_b));
    halves.below.push_back(moved(cut, -gap * normal));
    halves.above.push_back(moved(cut, gap * normal));
  }
  // A piece that only touches the plane is not cut.
  const auto reaches = [&](const Piece& half) {
    return std::any_of(half.begin(), half.end(), [&](const PieceCorner& corner) {
      return std::abs(dot(normal, corner.position) - offset) > 2 * (tolerance + gap);
    });
  };
  if (!reaches(halves.below)) return {{}, piece};
  if (!reaches(halves.above)) return {piece, {}};
  return halves;
}

std::vector<Polygon> polygons_of(const std::vector<Piece>& pieces, const Polygon& polygon, Scene* scene) {
  const bool has_uvs = polygon.uvs[0] != kNone;
  std::vector<Polygon> polygons;
  for (const Piece& piece : pieces) {
    const auto first_vertex = static_cast<uint32_t>(scene->vertices.size());
    const auto first_uv = static_cast<uint32_t>(scene->uvs.size());
    for (const PieceCorner& corner : piece) {
      scene->vertices.push_back(as_kept(corner.position));
      if (has_uvs) scene->uvs.push_back({static_cast<float>(corner.uv.x), static_cast<float>(corner.uv.y)});
    }
    // A fan of quads; the last may be a triangle.
    const auto count = static_cast<uint32_t>(piece.size());
    for (uint32_t next = 1; next + 1 < count; next += 2) {
      Polygon part;
      part.material = polygon.material;
      part.object = polygon.object;
      const uint32_t corners[4] = {0, next, next + 1, next + 2 < count ? next + 2 : kNone};
      for (int c = 0; c < 4 && corners[c] != kNone; ++c) {
        part.corners[c] = first_vertex + corners[c];
        if (has_uvs) part.uvs[c] = first_uv + corners[c];
      }
      polygons.push_back(part);
    }
  }
  return polygons;
}

}  // namespace strad
