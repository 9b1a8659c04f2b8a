// Differences and jumps of solutions that are written down by hand.
#include "frame/solution_diff.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace strad {
namespace {

constexpr float kFullIrradiance = 3.14159265f;  // with reflectance 0.5: radiance 0.5

// A unit square of reflectance 0.5, with a dark back.
Scene square() {
  Scene scene;
  scene.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  scene.polygons = {Polygon{.corners = {0, 1, 2, 3}}};
  scene.objects = {Object{.name = "square"}};
  scene.materials.emplace_back();  // reflects half
  scene.start = 0;
  scene.end = 4;
  return scene;
}

// Constant in both halves of [0, 4] s, on all of the square.
Slab two_halves(float first, float second) {
  Slab slab;
  slab.grid = make_time_grid(0, 4, {}, 1, 4);
  for (const Vec3& position : square().vertices) slab.mesh.vertices.push_back({.position = position});
  slab.mesh.elements = {Element{.vertices = {0, 1, 2, 3}}};
  slab.mesh.faces = {Face{}};
  slab.mesh.face_of_side = {0, kNone};
  for (Field* field : {&slab.direct, &slab.indirect}) {
    field->order = 1;
    for (int vertex = 0; vertex < 4; ++vertex) {
      field->pieces.insert(field->pieces.end(), {Interval{0, 1}, Interval{2, 1}});
      for (const float value : {first, second}) {
        const float half = value * kFullIrradiance / 2;  // the other half is the other field's
        field->coefficients.push_back({half, half, half});
      }
      field->first_piece.push_back(static_cast<uint32_t>(field->pieces.size()));
    }
  }
  return slab;
}

TEST(SolutionDiff, RadianceIsEmittedAndReflected) {
  Scene scene = square();
  scene.materials[0].emission = {1, 2, 3};
  const Solution solution{{two_halves(1, 2)}};
  const std::vector<RestSample> samples = {{0, 0, {0.3, 0.6, 0}}, {0, 1, {0.3, 0.6, 0}}};
  const Image radiance = radiance_of(scene, solution, samples, {0.5, 3.5}, false);
  EXPECT_NEAR(radiance.at(0, 0).r, 1 + 0.5, 1e-5);
  EXPECT_NEAR(radiance.at(1, 0).b, 3 + 1, 1e-5);
  EXPECT_EQ(radiance.at(0, 1), Rgb{});  // the back neither emits nor receives
}

TEST(SolutionDiff, IsThatOfTheirRadiance) {
  // L = 0.5 against 1 everywhere: rel_rmse 1, bias 1, largest difference 0.5.
  const Scene scene = square();
  const Solution a{{two_halves(1, 1)}}, b{{two_halves(2, 2)}};
  const SolutionsComparison c = compare_solutions({"a", scene, a}, {"b", scene, b});
  EXPECT_NEAR(rel_rmse(c.total), 1, 1e-5);
  EXPECT_NEAR(bias(c.total), 1, 1e-5);
  EXPECT_NEAR(c.total.largest, 0.5, 1e-5);
  EXPECT_EQ(c.object, "square");
  EXPECT_EQ(c.begin, 0);
  EXPECT_EQ(c.end, 4);
  EXPECT_EQ(rel_rmse(compare_solutions({"a", scene, a}, {"b", scene, a}).total), 0);
}

TEST(SolutionDiff, TheWorstDateIsNamed) {
  const Scene scene = square();
  const Solution a{{two_halves(1, 1)}}, b{{two_halves(1, 3)}};
  const SolutionsComparison c = compare_solutions({"a", scene, a}, {"b", scene, b});
  EXPECT_GT(c.time, 2);
  EXPECT_NEAR(c.total.worst.b, 1.5, 0.02);  // reached at 4 s, as the boundary at 2 s is smoothed
}

TEST(SolutionDiff, AnInstantIsComparedAtItsTime) {
  const Scene scene = square();
  const Solution a{{two_halves(1, 3)}};
  // The pieces 1 and 3 meet in 2 at 2 s; the correction fades within the cell of 1 s, so at 3 s there are 3.
  Slab instant = two_halves(3, 3);
  instant.grid = instant_grid(3);
  for (Field* field : {&instant.direct, &instant.indirect})
    for (Interval& piece : field->pieces) piece = {0, 0};
  for (Field* field : {&instant.direct, &instant.indirect}) {
    field->first_piece = {0, 1, 2, 3, 4};
    field->pieces.resize(4);
    field->coefficients.resize(4);
  }
  const Solution b{{instant}};
  const SolutionsComparison c = compare_solutions({"a", scene, a}, {"b", scene, b});
  EXPECT_EQ(c.begin, 3);
  EXPECT_EQ(c.end, 3);
  EXPECT_NEAR(rel_rmse(c.total), 0, 1e-6);
}

TEST(SolutionDiff, OtherGeometryIsRefused) {
  const Scene scene = square();
  Scene moved = square();
  moved.vertices[2].x = 2;
  Scene more = square();
  more.polygons.push_back(more.polygons[0]);
  const Solution solution{{two_halves(1, 1)}};
  EXPECT_THROW(compare_solutions({"a", scene, solution}, {"b", moved, solution}), BadInput);
  EXPECT_THROW(compare_solutions({"a", scene, solution}, {"b", more, solution}), BadInput);
}

TEST(SolutionDiff, OtherTimesAreRefused) {
  const Scene scene = square();
  const Solution a{{two_halves(1, 1)}};
  Solution later = a;
  for (Span& span : later.slabs[0].grid.spans) {
    span.begin += 10;
    span.end += 10;
  }
  EXPECT_THROW(compare_solutions({"a", scene, a}, {"b", scene, later}), BadInput);
}

TEST(Jump, IsThatOfTheRadianceAndGoesAwayWhereTimeIsReconstructed) {
  // L = 0.5 before and 1 after: jump 0.5 over the mean just before, 0.5. None elsewhere, and none when
  // corrected.
  const Scene scene = square();
  const Solution solution{{two_halves(1, 2)}};
  EXPECT_NEAR(jump_of({"a", scene, solution}, 2).as_solved, 1, 1e-5);
  EXPECT_NEAR(jump_of({"a", scene, solution}, 2).continuous, 0, 1e-5);
  EXPECT_NEAR(jump_of({"a", scene, solution}, 1).as_solved, 0, 1e-5);
  EXPECT_THROW(jump_of({"a", scene, solution}, 0), BadInput);
  EXPECT_THROW(jump_of({"a", scene, solution}, 4), BadInput);
}

TEST(SurfaceSamples, AreaDecidesHowManyASideGets) {
  Scene scene = square();
  scene.vertices.insert(scene.vertices.end(), {{5, 0, 0}, {8, 0, 0}, {5, 2, 0}});
  scene.polygons.push_back(Polygon{.corners = {4, 5, 6, kNone}});  // area 3
  const std::vector<RestSample> samples = surface_samples(scene, {true, false, false, true}, 400);
  ASSERT_EQ(samples.size(), 400u);
  Vec3 sum[2];
  int count[2] = {0, 0};
  for (const RestSample& sample : samples) {
    EXPECT_EQ(sample.side, sample.polygon);
    sum[sample.polygon] += sample.rest_point;
    ++count[sample.polygon];
    if (sample.polygon == 1) {
      EXPECT_LE((sample.rest_point.x - 5) / 3 + sample.rest_point.y / 2, 1 + 1e-9);
    }
  }
  EXPECT_NEAR(count[0], 100, 1);
  // Their means are the centres of gravity, (0.5, 0.5) and (6, 2/3), to the accuracy of a low-discrepancy
  // sequence.
  EXPECT_NEAR(sum[0].x / count[0], 0.5, 0.03);
  EXPECT_NEAR(sum[0].y / count[0], 0.5, 0.03);
  EXPECT_NEAR(sum[1].x / count[1], 6, 0.03);
  EXPECT_NEAR(sum[1].y / count[1], 2.0 / 3, 0.03);
  EXPECT_TRUE(surface_samples(scene, {false, false, false, false}, 400).empty());
}

}  // namespace
}  // namespace strad
