// Pictures of meshes made by hand, and of scenes whose openness has a closed form.
#include "frame/show.h"

#include <gtest/gtest.h>

#include "base/parallel.h"
#include "frame/show_error.h"
#include "frame/show_openness.h"
#include "synthetic.h"

namespace strad {
namespace {

ShowOptions small(ShowWhat what, uint32_t width = 16, uint32_t height = 16) {
  ShowOptions options;
  options.what = what, options.width = width, options.height = height;
  return options;
}

double mean_of_red(const Image& image) {
  double sum = 0;
  for (const Rgb& pixel : image.pixels) sum += pixel.r;
  return sum / static_cast<double>(image.pixels.size());
}

// Splits the only element of a quad's front, with surpluses of `middle` at the middle of its first edge and 0
// at the other new vertices.
void split_front(uint32_t polygon, Rgb middle, Slab* slab) {
  Mesh& mesh = slab->mesh;
  const uint32_t root = mesh.faces[mesh.face_of_side[2 * polygon]].element;
  const Element parent = mesh.elements[root];
  const uint32_t* v = parent.vertices;
  uint32_t m[5];  // of the edges, and of the quad
  for (int i = 0; i < 5; ++i) {
    MeshVertex vertex;
    for (int k = 0; k < (i < 4 ? 2 : 4); ++k) {
      vertex.parents[k] = i < 4 ? v[(i + k) % 4] : v[k];
      vertex.position += (i < 4 ? 0.5 : 0.25) * mesh.vertices[vertex.parents[k]].position;
    }
    if (i < 4 && vertex.parents[0] > vertex.parents[1]) std::swap(vertex.parents[0], vertex.parents[1]);
    m[i] = static_cast<uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(vertex);
    if (i == 0) {
      slab->indirect.pieces.push_back({0, 0});
      slab->indirect.coefficients.push_back(middle);
    }
    slab->indirect.first_piece.push_back(static_cast<uint32_t>(slab->indirect.pieces.size()));
    slab->direct.first_piece.push_back(0);
  }
  mesh.elements[root].first_child = static_cast<uint32_t>(mesh.elements.size());
  mesh.elements.push_back({{v[0], m[0], m[4], m[3]}});
  mesh.elements.push_back({{m[0], v[1], m[1], m[4]}});
  mesh.elements.push_back({{m[4], m[1], v[2], m[2]}});
  mesh.elements.push_back({{m[3], m[4], m[2], v[3]}});
}

// A floor of reflectance 1 that reaches beyond the picture, which shows x and y in [0, 8], 2 pixels a metre.
Scene floor_scene() {
  Scene scene;
  scene.end = 1;
  add_quad(&scene, {-4, -4, 0}, {12, -4, 0}, {12, 12, 0}, {-4, 12, 0}, {1, 1, 1});
  add_camera(&scene, {4, 4, 4}, {4, 4, 0}, {0, 1, 0}, 90);
  return scene;
}

// Split in the middle of the picture: four colours, each even, and between two of them one pixel that is a
// fifth of their mean.
TEST(Show, ElementsHaveColoursAndBorders) {
  const Scene scene = floor_scene();
  Slab slab = even_slab(scene, {1, 1, 1});
  split_front(0, {}, &slab);
  const Image image = Show(scene).render(&slab, scene.cameras[0], 0, small(ShowWhat::kElements));
  for (uint32_t y = 0; y < 16; ++y)
    for (uint32_t x = 0; x < 16; ++x) {
      if (x == 7 || x == 8 || y == 7 || y == 8) continue;
      EXPECT_EQ(image.at(x, y), image.at(x < 8 ? 0 : 15, y < 8 ? 0 : 15));
    }
  const Rgb quarters[4] = {image.at(0, 0), image.at(15, 0), image.at(15, 15), image.at(0, 15)};
  for (int i = 0; i < 4; ++i) {
    const Rgb a = quarters[i], b = quarters[(i + 1) % 4];
    EXPECT_NE(a, b);
    EXPECT_NE(a, quarters[(i + 2) % 4]);
    const auto on_border = [&](Rgb pixel) { return max_channel(pixel) < 0.21f * max_channel(a + b); };
    const Rgb at7 = i % 2 == 0 ? image.at(7, i == 0 ? 2 : 13) : image.at(i == 1 ? 13 : 2, 7);
    const Rgb at8 = i % 2 == 0 ? image.at(8, i == 0 ? 2 : 13) : image.at(i == 1 ? 13 : 2, 8);
    ASSERT_NE(on_border(at7), on_border(at8));
    const Rgb border = on_border(at7) ? at7 : at8;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(border[c], 0.2f * 0.5f * (a[c] + b[c]), 1e-6f);
  }
}

// The floor moves by 1 m, which is 2 pixels, within a second: so does the picture.
TEST(Show, ElementsKeepTheirColoursAsBodiesMove) {
  Scene scene = floor_scene();
  scene.bodies.push_back({});
  scene.bodies.back().name = "floor";
  scene.bodies.back().keys = {{0, {0, 0, 0}, 0, false, {}}, {1, {1, 0, 0}, 0, false, {}}};
  scene.objects.back().body = 1;
  Slab slab = even_slab(scene, {1, 1, 1});
  split_front(0, {}, &slab);
  const Show show(scene);
  const Image before = show.render(&slab, scene.cameras[0], 0, small(ShowWhat::kElements));
  const Image after = show.render(&slab, scene.cameras[0], 1, small(ShowWhat::kElements));
  for (uint32_t y = 0; y < 6; ++y)
    for (uint32_t x = 0; x + 2 < 16; ++x) {
      if (x == 7 || x == 8) continue;
      EXPECT_EQ(after.at(x + 2, y), before.at(x, y));
    }
  EXPECT_NE(before, after);
}

// Radiance is E / pi: 2 at the corners, 2.4 at the middle of one edge where interpolation says 2, and 2 at
// the other new vertices. The leaves' means are 2.1, 2.1, 2 and 2, that of all 2.05 (the back is the same
// size and never split: 2, so the mean of both sides is 2.025). A quarter of the surplus is left: 0.25 * 0.4
// / 2.025.
TEST(Show, ErrorIsAQuarterOfTheSurplusOverTheMean) {
  const Scene scene = floor_scene();
  const float pi = static_cast<float>(kPi);
  Slab slab = even_slab(scene, {2 * pi, 2 * pi, 2 * pi});
  split_front(0, {0.4f * pi, 0.4f * pi, 0.4f * pi}, &slab);
  const std::vector<float> errors = element_errors(scene, slab, 0);
  ASSERT_EQ(errors.size(), 6u);
  EXPECT_TRUE(std::isnan(errors[0]));  // the root, and the back
  EXPECT_TRUE(std::isnan(errors[1]));
  for (size_t leaf = 2; leaf < 6; ++leaf) EXPECT_NEAR(errors[leaf], 0.25 * 0.4 / 2.025, 1e-5);
}

// White from 10 % on, black at 0, grey where nothing is known; one stop more shows half the error as white.
TEST(Show, ErrorIsAHeatMap) {
  Image values(4, 1);
  values.at(1, 0) = {0.1f, 0.1f, 0.1f};
  values.at(2, 0) = {3, 3, 3};
  const float unknown = std::numeric_limits<float>::quiet_NaN();
  values.at(3, 0) = {unknown, unknown, unknown};
  const Image colours = error_colours(values);
  EXPECT_EQ(colours.at(0, 0), (Rgb{0, 0, 0}));
  EXPECT_EQ(colours.at(1, 0), (Rgb{1, 1, 1}));
  EXPECT_EQ(colours.at(2, 0), (Rgb{1, 1, 1}));
  EXPECT_EQ(colours.at(3, 0), (Rgb{0.18f, 0.18f, 0.18f}));
}

// No ray of a closed cube of 2 m gets farther than its diagonal, 3.47 m; all rays get 0.5 m far from the
// middle of a wall, which is 1 m from the next.
TEST(Show, OpennessOfAClosedCube) {
  Scene scene;
  add_room(&scene, {0, 0, 0}, {2, 2, 2}, {0.5f, 0.5f, 0.5f}, {});
  add_camera(&scene, {1, 1, 1}, {2, 1, 1}, {0, 0, 1}, 20);
  const Show show(scene);
  ShowOptions options = small(ShowWhat::kOpenness);
  options.within = 3.5;
  EXPECT_EQ(show.render(nullptr, scene.cameras[0], 0, options), Image(16, 16));
  options.within = 0.5;
  EXPECT_EQ(show.render(nullptr, scene.cameras[0], 0, options), Image(16, 16, {1, 1, 1}));
}

TEST(Show, OpennessOfAnOpenPlane) {
  const Scene scene = floor_scene();
  ShowOptions options = small(ShowWhat::kOpenness);
  options.within = 1000;
  EXPECT_EQ(Show(scene).render(nullptr, scene.cameras[0], 0, options), Image(16, 16, {1, 1, 1}));
}

// A wall of height h = 1 m and no end takes (1 - a / sqrt(a^2 + h^2)) / 2 of the view of a point of the floor
// a = 0.75 m before it: 0.2. 65,536 rays have a standard deviation of 0.4 / 256 = 0.0016 at most.
TEST(Show, OpennessBesideAWall) {
  Scene scene;
  add_quad(&scene, {0, -500, 0}, {9, -500, 0}, {9, 500, 0}, {0, 500, 0});
  add_quad(&scene, {0, -500, 0}, {0, 500, 0}, {0, 500, 1}, {0, -500, 1});
  add_camera(&scene, {0.75, 0, 5}, {0.75, 0, 0}, {0, 1, 0}, 0.01);
  ShowOptions options = small(ShowWhat::kOpenness);
  options.within = 10000;
  options.samples = 64;
  EXPECT_NEAR(mean_of_red(Show(scene).render(nullptr, scene.cameras[0], 0, options)), 0.8, 0.006);
}

TEST(Show, AnyNumberOfThreadsGivesTheSamePicture) {
  Scene scene;
  add_room(&scene, {0, 0, 0}, {2, 2, 2}, {0.5f, 0.5f, 0.5f}, {});
  add_camera(&scene, {1, 1, 1}, {2, 2, 2}, {0, 0, 1}, 90);
  Slab slab = even_slab(scene, {1, 1, 1});
  split_front(0, {0.1f, 0.1f, 0.1f}, &slab);
  const Show show(scene);
  for (const ShowWhat what : {ShowWhat::kElements, ShowWhat::kError, ShowWhat::kOpenness}) {
    set_thread_count(1);
    const Image one = show.render(&slab, scene.cameras[0], 0, small(what));
    set_thread_count(3);
    EXPECT_EQ(show.render(&slab, scene.cameras[0], 0, small(what)), one);
  }
}

}  // namespace
}  // namespace strad
