// Polygons of any outline become planar convex pieces that cover them exactly.
#include <gtest/gtest.h>

#include "import/polygonize.h"

namespace strad {
namespace {

Vec3 doubled_area(const std::vector<Vec3>& p) {
  Vec3 sum;
  for (size_t i = 1; i + 1 < p.size(); ++i) sum += cross(p[i] - p[0], p[i + 1] - p[0]);
  return sum;
}

std::vector<Vec3> corners_of(const std::vector<Vec3>& outline, const OutlinePiece& piece) {
  std::vector<Vec3> corners;
  for (const int c : piece.corners)
    if (c >= 0) corners.push_back(outline[static_cast<size_t>(c)]);
  return corners;
}

bool inside(const std::vector<Vec3>& outline, double x, double y) {  // even-odd, in the xy plane
  bool in = false;
  for (size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Vec3 a = outline[i], b = outline[j];
    if ((a.y > y) != (b.y > y) && x < (b.x - a.x) * (y - a.y) / (b.y - a.y) + a.x) in = !in;
  }
  return in;
}

// Each point of a fine grid lies in exactly one piece if it is inside the outline, in none if it is outside.
void expect_exact_cover(const std::vector<Vec3>& outline) {
  std::vector<OutlinePiece> pieces;
  ASSERT_EQ(polygonize(outline, &pieces), Outline::kWhole);
  Box box;
  for (const Vec3 p : outline) box.add(p);
  for (int i = 0; i < 97; ++i) {
    for (int j = 0; j < 89; ++j) {
      const double x = box.lower.x + (i + 0.437) / 97 * (box.upper.x - box.lower.x);
      const double y = box.lower.y + (j + 0.519) / 89 * (box.upper.y - box.lower.y);
      int covered = 0;
      for (const OutlinePiece& piece : pieces) covered += inside(corners_of(outline, piece), x, y);
      ASSERT_EQ(covered, inside(outline, x, y) ? 1 : 0) << "at " << x << " " << y;
    }
  }
  for (const OutlinePiece& piece : pieces) {  // same winding, convex
    const std::vector<Vec3> p = corners_of(outline, piece);
    for (size_t k = 0; k < p.size(); ++k)
      EXPECT_GT(cross(p[(k + 1) % p.size()] - p[k], p[(k + 2) % p.size()] - p[(k + 1) % p.size()]).z, 0);
  }
}

TEST(polygonize, keeps_a_planar_convex_quad) {
  std::vector<OutlinePiece> pieces;
  EXPECT_EQ(polygonize(std::vector<Vec3>{{0, 0, 5}, {2, 0, 5}, {2, 1, 5}, {0, 1, 5}}, &pieces),
            Outline::kWhole);
  ASSERT_EQ(pieces.size(), 1u);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(pieces[0].corners[k], k);
}

TEST(polygonize, keeps_a_planar_quad_far_from_the_origin) {
  // Coordinates as floats hold them at 8 km: steps of half a millimetre.
  std::vector<OutlinePiece> pieces;
  polygonize(std::vector<Vec3>{{8434.8086, 6083.6548, 2.387},
                               {8434.8086, 6083.6548, 71.633},
                               {8432.3096, 6092.2061, 71.633},
                               {8432.3096, 6092.2061, 2.387}},
             &pieces);
  EXPECT_EQ(pieces.size(), 1u);
}

TEST(polygonize, splits_a_bent_quad_into_two_triangles) {
  std::vector<OutlinePiece> pieces;
  EXPECT_EQ(polygonize(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.01}, {0, 1, 0}}, &pieces),
            Outline::kWhole);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].corners[3], -1);
  EXPECT_EQ(pieces[1].corners[3], -1);
}

TEST(polygonize, splits_a_concave_quad) {
  const std::vector<Vec3> dart{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}};
  expect_exact_cover(dart);
  std::vector<OutlinePiece> pieces;
  polygonize(dart, &pieces);
  EXPECT_EQ(pieces.size(), 2u);
}

TEST(polygonize, cuts_an_l_shape_into_two_quads) {
  const std::vector<Vec3> shape{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  expect_exact_cover(shape);
  std::vector<OutlinePiece> pieces;
  polygonize(shape, &pieces);
  EXPECT_EQ(pieces.size(), 2u);
}

TEST(polygonize, cuts_a_comb) {
  std::vector<Vec3> comb{{0, 0, 0}, {11, 0, 0}};
  for (int tooth = 5; tooth >= 0; --tooth) {
    comb.push_back({2.0 * tooth + 1, 5, 0});
    comb.push_back({2.0 * tooth, 5, 0});
    if (tooth > 0) comb.push_back({2.0 * tooth, 1, 0}), comb.push_back({2.0 * tooth - 1, 1, 0});
  }
  expect_exact_cover(comb);
}

TEST(polygonize, cuts_a_spiral) {
  std::vector<Vec3> spiral;
  for (int i = 0; i <= 60; ++i)
    spiral.push_back({(1 + i * 0.1) * cos(i * 0.3), (1 + i * 0.1) * sin(i * 0.3), 0});
  for (int i = 60; i >= 0; --i)
    spiral.push_back({(0.5 + i * 0.1) * cos(i * 0.3), (0.5 + i * 0.1) * sin(i * 0.3), 0});
  expect_exact_cover(spiral);
}

TEST(polygonize, walks_bridges_to_holes) {
  // A square of 4 with two square holes, each joined to the outline by an edge walked both ways.
  expect_exact_cover({{0, 0, 0},
                      {4, 0, 0},
                      {4, 4, 0},
                      {3.5, 3.5, 0},
                      {3.5, 2.5, 0},
                      {2.5, 2.5, 0},
                      {2.5, 3.5, 0},
                      {3.5, 3.5, 0},
                      {4, 4, 0},
                      {0, 4, 0},
                      {0, 0, 0},
                      {1, 1, 0},
                      {1, 2, 0},
                      {2, 2, 0},
                      {2, 1, 0},
                      {1, 1, 0}});
}

TEST(polygonize, walks_two_bridges_from_one_corner) {
  expect_exact_cover({{0, 0, 0},
                      {1, 2, 0},
                      {1, 3, 0},
                      {2, 3, 0},
                      {1, 2, 0},
                      {0, 0, 0},
                      {3, 1, 0},
                      {2, 1, 0},
                      {3, 2, 0},
                      {3, 1, 0},
                      {0, 0, 0},
                      {9, 0, 0},
                      {9, 9, 0},
                      {0, 9, 0}});
}

TEST(polygonize, leaves_out_corners_on_straight_edges) {
  std::vector<OutlinePiece> pieces;
  EXPECT_EQ(
      polygonize(
          std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {0, 2, 0}, {0, 1, 0}},
          &pieces),
      Outline::kWhole);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].corners[3], 5);
}

TEST(polygonize, drops_what_has_no_area) {
  std::vector<OutlinePiece> pieces;
  const Vec3 a{1, 1, 1}, b{2, 1, 1}, c{3, 1, 1};
  EXPECT_EQ(polygonize(std::vector<Vec3>{a, a, a}, &pieces), Outline::kDegenerate);
  EXPECT_EQ(polygonize(std::vector<Vec3>{a, b, a}, &pieces), Outline::kDegenerate);
  EXPECT_EQ(polygonize(std::vector<Vec3>{a, b, c}, &pieces), Outline::kDegenerate);
  EXPECT_EQ(polygonize(std::vector<Vec3>{a, b, c, b}, &pieces), Outline::kDegenerate);
  EXPECT_EQ(polygonize(std::vector<Vec3>{a, a, b, b, a}, &pieces), Outline::kDegenerate);
  EXPECT_TRUE(pieces.empty());
}

TEST(polygonize, drops_a_repeated_corner) {
  std::vector<OutlinePiece> pieces;
  EXPECT_EQ(polygonize(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}}, &pieces),
            Outline::kWhole);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].corners[3], -1);
}

TEST(polygonize, tells_of_an_outline_that_crosses_itself) {
  std::vector<OutlinePiece> pieces;
  EXPECT_EQ(polygonize(std::vector<Vec3>{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {1, -2, 0}}, &pieces),
            Outline::kCrossing);
}

TEST(polygonize, stays_in_the_corners_of_any_outline) {
  // Points in a fixed random order: most outlines cross themselves. None may crash, or use a corner that does
  // not exist.
  uint32_t state = 1;
  const auto random = [&state] { return (state = state * 1664525u + 1013904223u) >> 24; };
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<Vec3> outline(3 + random() % 12);
    for (Vec3& p : outline)
      p = {static_cast<double>(random() % 5), static_cast<double>(random() % 5),
           trial % 3 ? 0.0 : random() % 2};
    std::vector<OutlinePiece> pieces;
    const Outline result = polygonize(outline, &pieces);
    EXPECT_EQ(result == Outline::kDegenerate, pieces.empty() && result != Outline::kCrossing);
    for (const OutlinePiece& piece : pieces) {
      for (const int c : piece.corners) ASSERT_LT(c, static_cast<int>(outline.size()));
      EXPECT_GT(length(doubled_area(corners_of(outline, piece))), 0);
    }
  }
}

}  // namespace
}  // namespace strad
