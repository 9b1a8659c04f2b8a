// Indirect light on the mesh: exact where it is uniform, more of it where it is not.
#include "solve/gather/indirect_phase.h"

#include <gtest/gtest.h>

#include "refined.h"
#include "solve/links/leaves.h"

namespace strad {
namespace {

Scene room() {
  Scene scene;
  scene.end = 1;
  add_box(&scene, {0, 0, 0}, {4, 3, 2}, true);
  add_spot(&scene, {2, 1.5, 1.9}, {1, 1, 0}, 0.4, 0.5, {10, 10, 10});
  return scene;
}

// Runs the phase over leaves of given radiance, by their centre; counts the pieces of functions that it
// keeps.
struct GatheredRoom {
  Refined refined{room(), Roots::kFaces, {0.02}};
  Field field;
  size_t pieces = 0;

  template <typename Radiance>
  explicit GatheredRoom(const Radiance& radiance_at) {
    Workbench& bench = refined.bench;
    refined.direct->take_surpluses();
    FunctionBlock radiance(bench.nodes->leaf_count(), leaves_of(*bench.nodes), bench.grid.sample_count());
    for (const uint32_t leaf : radiance.rows())
      for (size_t d = 0; d < radiance.sample_count(); ++d)
        radiance.set(leaf, d, radiance_at(bench.nodes->nodes()[leaf].centre));
    const FinalGather gather(*bench.nodes, bench.tracer, bench.grid, bench.swept, radiance, {}, {}, {256});
    IndirectOptions options;
    options.largest_element = 2, options.smallest_element = 0.2;
    options.threshold = 0.01f, options.tolerance = 0.001f;
    IndirectPhase phase(bench.scene, bench.grid, gather, options, &bench.builder);
    phase.run();
    field = phase.take_surpluses();
    pieces = field.pieces.size();
  }
};

// All that is seen has radiance 1: E is pi at the corners of faces, and what other vertices differ from the
// mean of their parents is 0.
TEST(IndirectPhase, UniformLightIsExact) {
  const GatheredRoom run([](Vec3) { return Rgb{1, 1, 1}; });
  const Mesh& mesh = run.refined.bench.builder.mesh();
  ASSERT_EQ(run.field.row_count(), mesh.vertices.size());
  for (uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    const double expected = mesh.vertices[v].parent_count() == 0 ? kPi : 0;
    EXPECT_NEAR(value_at(run.refined.bench.grid, run.field, v, 0.5, false).g, expected, 0.005) << v;
  }
}

// One end of the room bright, the other dark: more vertices hold what interpolation lacks.
TEST(IndirectPhase, KeepsMoreWhereLightVaries) {
  const GatheredRoom uniform([](Vec3) { return Rgb{1, 1, 1}; });
  const GatheredRoom varying([](Vec3 at) { return at.x < 1 ? Rgb{4, 4, 4} : Rgb{0.1f, 0.1f, 0.1f}; });
  EXPECT_GT(varying.pieces, 2 * uniform.pieces);
}

}  // namespace
}  // namespace strad
