// Irradiance of hand-made solutions, and the refusal of broken ones.
#include "solution/solution.h"

#include <gtest/gtest.h>

#include <functional>

#include "base/error.h"

namespace strad {
namespace {

constexpr Rgb kOne{1, 1, 1};

// A unit square, front side only, split once: corners 0..3, edge middles 4..7, centre 8.
Scene square_scene() {
  Scene scene;
  scene.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  scene.polygons.push_back({{0, 1, 2, 3}, {kNone, kNone, kNone, kNone}, 0, 0});
  return scene;
}
Mesh square_mesh() {
  Mesh mesh;
  mesh.vertices = {{{kNone, kNone, kNone, kNone}, {0, 0, 0}},
                   {{kNone, kNone, kNone, kNone}, {1, 0, 0}},
                   {{kNone, kNone, kNone, kNone}, {1, 1, 0}},
                   {{kNone, kNone, kNone, kNone}, {0, 1, 0}},
                   {{0, 1, kNone, kNone}, {0.5, 0, 0}},
                   {{1, 2, kNone, kNone}, {1, 0.5, 0}},
                   {{2, 3, kNone, kNone}, {0.5, 1, 0}},
                   {{3, 0, kNone, kNone}, {0, 0.5, 0}},
                   {{0, 1, 2, 3}, {0.5, 0.5, 0}}};
  mesh.elements = {{{0, 1, 2, 3}, 1},
                   {{0, 4, 8, 7}, kNone},
                   {{4, 1, 5, 8}, kNone},
                   {{8, 5, 2, 6}, kNone},
                   {{7, 8, 6, 3}, kNone}};
  mesh.faces = {{0, 0, 0}};
  mesh.face_of_side = {0, kNone};
  return mesh;
}

// One span of 4 cells over [begin, begin + 4], linear pieces.
TimeGrid linear_grid(double begin) {
  TimeGrid grid;
  grid.order = 2;
  grid.spans = {{begin, begin + 4, 0, 2}};
  return grid;
}

// Rows that are value(vertex) * (time - begin), each in two pieces of two cells.
Field ramps(const TimeGrid& grid, const std::vector<float>& slopes) {
  Field field;
  field.order = 2;
  for (const float slope : slopes) {
    for (const uint32_t cell : {0u, 2u}) {
      const Interval piece{cell, 1};
      field.pieces.push_back(piece);
      const double begin = interval_begin(grid, piece), length = interval_end(grid, piece) - begin;
      for (int i = 0; i < 2; ++i) {
        const double time = begin + length * gauss_nodes(2)[i] - grid.spans[0].begin;
        field.coefficients.push_back(slope * static_cast<float>(time) * kOne);
      }
    }
    field.first_piece.push_back(static_cast<uint32_t>(field.pieces.size()));
  }
  return field;
}

// Corner slopes 1 2 3 4, surplus 0.5 at the first edge's middle and 1 at the centre; indirect is a tenth of
// it all.
Slab square_slab(double begin) {
  Slab slab;
  slab.grid = linear_grid(begin);
  slab.mesh = square_mesh();
  slab.direct = ramps(slab.grid, {1, 2, 3, 4, 0.5f, 0, 0, 0, 1});
  slab.indirect = ramps(slab.grid, {0.1f, 0.2f, 0.3f, 0.4f, 0.05f, 0, 0, 0, 0.1f});
  return slab;
}

TEST(Solution, VertexValuesAddParents) {
  const VertexLight light = light_at(square_slab(10), 12);  // 2 s after the beginning: twice the slopes
  EXPECT_NEAR(light.direct[0].r, 2, 1e-5);
  EXPECT_NEAR(light.direct[4].g, 2 * (1.5 + 0.5), 1e-5);
  EXPECT_NEAR(light.direct[5].b, 2 * 2.5, 1e-5);
  EXPECT_NEAR(light.direct[8].r, 2 * (2.5 + 1), 1e-5);
  EXPECT_NEAR(light.indirect[8].r, 0.2 * (2.5 + 1), 1e-6);
}

TEST(Solution, MeanOverTimeIsTheMiddleOfARamp) {
  const Slab slab = square_slab(10);
  const VertexLight mean = light_over(slab, 10.5, 13.5), middle = light_at(slab, 12);
  for (size_t v = 0; v < mean.direct.size(); ++v) {
    EXPECT_NEAR(mean.direct[v].r, middle.direct[v].r, 1e-5);
    EXPECT_NEAR(mean.indirect[v].r, middle.indirect[v].r, 1e-6);
  }
}

TEST(Solution, PointAgreesWithVertices) {
  const Slab slab = square_slab(0);
  const VertexLight light = light_at(slab, 3);
  for (const Vec2 uv : {Vec2{0.1, 0.2}, Vec2{0.5, 0.5}, Vec2{0.9, 0.05}, Vec2{0.3, 1}}) {
    const MeshPoint point = locate(slab.mesh, 0, uv);
    Rgb expected_direct, expected_indirect;
    for (int i = 0; i < 4; ++i) {
      expected_direct += point.weights[i] * light.direct[point.vertices[i]];
      expected_indirect += point.weights[i] * light.indirect[point.vertices[i]];
    }
    EXPECT_NEAR(direct_at(slab, point, 3).r, expected_direct.r, 1e-5);
    EXPECT_NEAR(indirect_at(slab, point, 3).g, expected_indirect.g, 1e-6);
  }
}

TEST(Solution, SlabHoldsItsBeginning) {
  const Solution solution{{square_slab(0), square_slab(4)}};
  EXPECT_EQ(slab_at(solution, -1), 0u);
  EXPECT_EQ(slab_at(solution, 3.999), 0u);
  EXPECT_EQ(slab_at(solution, 4), 1u);
  EXPECT_EQ(slab_at(solution, 99), 1u);
}

TEST(Solution, SoundOneIsAccepted) {
  EXPECT_NO_THROW(validate(square_scene(), Solution{{square_slab(0), square_slab(4)}}));
}

// Each change breaks one thing that readers rely on.
void expect_refused(const std::function<void(Slab*)>& harm, const std::string& text) {
  Slab slab = square_slab(0);
  harm(&slab);
  try {
    validate(square_scene(), Solution{{slab}});
    ADD_FAILURE() << "not refused: " << text;
  } catch (const BadInput& fault) {
    EXPECT_NE(std::string(fault.what()).find(text), std::string::npos) << fault.what();
  }
}
TEST(Solution, BrokenMeshesAreRefused) {
  expect_refused([](Slab* s) { s->mesh.vertices[4].parents[0] = 4; }, "vertex 4");
  expect_refused([](Slab* s) { s->mesh.vertices[4].parents[1] = kNone; }, "0, 2 or 4 parents");
  expect_refused([](Slab* s) { s->mesh.vertices[2].position.x = NAN; }, "not finite");
  expect_refused([](Slab* s) { s->mesh.elements[2].vertices[1] = 9; }, "element 2");
  expect_refused([](Slab* s) { s->mesh.elements[0].first_child = 0; }, "element 0");
  expect_refused([](Slab* s) { s->mesh.elements[0].first_child = 2; }, "element 0");
  expect_refused([](Slab* s) { s->mesh.elements[3].vertices[3] = kNone; }, "number of corners");
  expect_refused([](Slab* s) { s->mesh.faces[0].polygon = 1; }, "face 0");
  expect_refused([](Slab* s) { s->mesh.faces[0].side = 1; }, "another face");
  expect_refused([](Slab* s) { s->mesh.faces[0].side = 2; }, "side 0 or 1");
  expect_refused([](Slab* s) { s->mesh.face_of_side = {0, 0}; }, "side 1");
  expect_refused([](Slab* s) { s->mesh.face_of_side = {0}; }, "polygons");
}
TEST(Solution, BrokenFunctionsOfTimeAreRefused) {
  expect_refused([](Slab* s) { s->grid.order = 4; }, "order 4");
  expect_refused([](Slab* s) { s->grid.spans.clear(); }, "no time spans");
  expect_refused([](Slab* s) { s->grid.spans[0].end = -1; }, "time span 0");
  expect_refused([](Slab* s) { s->grid.spans[0].log2_cells = 31; }, "cells");
  expect_refused([](Slab* s) { s->direct.order = 1; }, "order");
  expect_refused([](Slab* s) { s->direct.first_piece.pop_back(); }, "one function of time a vertex");
  expect_refused([](Slab* s) { s->direct.first_piece[3] = 99; }, "vertex 2");
  expect_refused([](Slab* s) { s->direct.first_piece[3] = 0; }, "out of range");
  expect_refused([](Slab* s) { s->direct.pieces[1].cell = 0; }, "overlap");
  expect_refused([](Slab* s) { s->direct.pieces[1].cell = 1; }, "not dyadic");
  expect_refused([](Slab* s) { s->direct.pieces[1].cell = 4; }, "outside");
  expect_refused([](Slab* s) { s->direct.pieces[0].log2_cells = 3; }, "longer than its span");
  expect_refused([](Slab* s) { s->indirect.coefficients[5].g = INFINITY; }, "coefficient 5");
  expect_refused([](Slab* s) { s->indirect.coefficients.pop_back(); }, "do not agree");
}

TEST(Solution, GapsBetweenSlabsAreRefused) {
  EXPECT_THROW(validate(square_scene(), Solution{{square_slab(0), square_slab(5)}}), BadInput);
}

}  // namespace
}  // namespace strad
