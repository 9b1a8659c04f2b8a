// Solutions in the stream: the same light to a stated error, whole or instant by instant.
#include "solution/solution_io.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "base/rng.h"
#include "solution/join.h"
#include "solution/light_code.h"
#include "solution/solution_file.h"
#include "solve/mesh/mesh_builder.h"

namespace strad {
namespace {

// Two quads in one plane that share an edge, and a triangle that stands on them.
Scene small_scene() {
  Scene scene;
  scene.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}, {0.5, 0.5, 1}};
  scene.polygons = {{{0, 1, 2, 3}, {kNone, kNone, kNone, kNone}, 0, 0},
                    {{1, 4, 5, 2}, {kNone, kNone, kNone, kNone}, 0, 0},
                    {{0, 2, 6, kNone}, {kNone, kNone, kNone, kNone}, 0, 0}};
  scene.objects = {{"all", 0}};
  scene.materials.resize(1);
  scene.end = 4;
  return scene;
}

// Splits half of all elements, `rounds` times over; neighbours share middles, some keep hanging vertices.
Mesh split_mesh(const Scene& scene, int rounds) {
  MeshBuilder builder(scene);
  builder.face(2, 1);
  for (uint32_t polygon = 0; polygon < 3; ++polygon) builder.face(polygon, 0);
  for (int round = 0; round < rounds; ++round) {
    const size_t count = builder.mesh().elements.size();
    for (uint32_t e = 0; e < count; ++e)
      if (builder.mesh().elements[e].first_child == kNone &&
          hash_of(e, static_cast<uint64_t>(round)) % 2 == 0)
        builder.split(e);
  }
  return builder.take();
}

// Light that moves about: long pieces for some vertices, short ones for others, none for a few.
Field moving_light(const TimeGrid& grid, size_t rows, float scale, uint64_t seed) {
  Field field;
  field.order = grid.order;
  for (size_t row = 0; row < rows; ++row) {
    const double phase = 6 * unit_from(hash_of(seed, row)), speed = 1 + 20.0 * (row % 7 == 0);
    std::vector<Rgb> values;
    for (uint32_t node = 0; node < grid.sample_count(); ++node) {
      const auto light = static_cast<float>(1 + std::sin(phase + speed * sample_time(grid, node)));
      values.push_back(scale * Rgb{light, 0.75f * light, 0.5f * light * light});
    }
    append_row(grid, values, {}, row % 5 == 4 ? 100 * scale : 0.01f * scale, &field);
  }
  return field;
}

Slab make_slab(const Scene& scene, double begin, double end, std::vector<double> steps = {}, int order = 3) {
  Slab slab;
  slab.grid = make_time_grid(begin, end, steps, order, 256 * order);
  slab.mesh = split_mesh(scene, 3);
  slab.direct = moving_light(slab.grid, slab.mesh.vertices.size(), 10, 1);
  slab.indirect = moving_light(slab.grid, slab.mesh.vertices.size(), 1, 2);
  return slab;
}

Bytes written(const Stream& stream) {
  Bytes bytes;
  StreamWriter writer([&bytes](ByteSpan more) { bytes.insert(bytes.end(), more.begin(), more.end()); });
  write_stream(stream, writer);
  return bytes;
}

Stream read_back(const Bytes& bytes) {
  StreamReader reader(bytes, "test");
  return read_stream(reader);
}

std::string fault_of(const Bytes& bytes) {
  try {
    read_back(bytes);
    return "";
  } catch (const BadInput& fault) {
    return fault.what();
  }
}

void expect_same_mesh(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  ASSERT_EQ(a.elements.size(), b.elements.size());
  ASSERT_EQ(a.faces.size(), b.faces.size());
  EXPECT_EQ(a.face_of_side, b.face_of_side);
  for (size_t v = 0; v < a.vertices.size(); ++v) {
    EXPECT_EQ(a.vertices[v].position, b.vertices[v].position);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(a.vertices[v].parents[i], b.vertices[v].parents[i]);
  }
  for (size_t e = 0; e < a.elements.size(); ++e) {
    EXPECT_EQ(a.elements[e].first_child, b.elements[e].first_child);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(a.elements[e].vertices[i], b.elements[e].vertices[i]);
  }
  for (size_t f = 0; f < a.faces.size(); ++f) {
    EXPECT_EQ(a.faces[f].polygon, b.faces[f].polygon);
    EXPECT_EQ(a.faces[f].side, b.faces[f].side);
    EXPECT_EQ(a.faces[f].element, b.faces[f].element);
  }
}

// Half a quantum of at most 2e-4 of the mean irradiance, or 1/512.
void expect_near(const Field& a, const Field& b, double quantum) {
  EXPECT_EQ(a.order, b.order);
  EXPECT_EQ(a.first_piece, b.first_piece);
  EXPECT_EQ(a.pieces, b.pieces);
  ASSERT_EQ(a.coefficients.size(), b.coefficients.size());
  for (size_t i = 0; i < a.coefficients.size(); ++i)
    for (int c = 0; c < 3; ++c)
      ASSERT_NEAR(a.coefficients[i][c], b.coefficients[i][c],
                  std::max(0.5 * quantum, std::abs(a.coefficients[i][c]) / 512.0) * 1.000001);
}

class TemporaryFile {
 public:
  explicit TemporaryFile(const Bytes& bytes) {
    char name[] = "/tmp/strad-test-XXXXXX";
    close(mkstemp(name));
    path = name;
    std::ofstream(path).write(reinterpret_cast<const char*>(bytes.data()),
                              static_cast<std::streamsize>(bytes.size()));
  }
  ~TemporaryFile() { std::filesystem::remove(path); }
  std::string path;
};

TEST(LightCode, KeepsHalfAQuantumOrEightBits) {
  const double quantum = 0x1p-10;
  for (double value = 1e-5; value < 1e9; value *= 1.0173) {
    const auto light = static_cast<float>(value);
    EXPECT_NEAR(light_of(light_code(light, quantum), quantum), light,
                std::max(quantum / 2, value / 512) * 1.000001);
    EXPECT_EQ(light_of(light_code(-light, quantum), quantum), -light_of(light_code(light, quantum), quantum));
  }
  EXPECT_EQ(light_of(light_code(0, quantum), quantum), 0);
}

TEST(LightCode, AscendsAndIsItsOwnInverse) {
  float previous = -1;
  for (int code = 0; code < 20000; ++code) {
    const float light = light_of(static_cast<int16_t>(code), 0x1p-10);
    EXPECT_GT(light, previous);
    EXPECT_EQ(light_code(light, 0x1p-10), code);
    previous = light;
  }
}

class SolutionIo : public testing::TestWithParam<int> {};  // order

TEST_P(SolutionIo, ComesBack) {
  const Scene scene = small_scene();
  const Slab slab = make_slab(scene, 0, 4, {}, GetParam());
  const Stream back = read_back(written({scene, Solution{{slab}}, {}}));
  ASSERT_TRUE(back.solution);
  ASSERT_EQ(back.solution->slabs.size(), 1u);
  const Slab& other = back.solution->slabs[0];
  EXPECT_EQ(other.grid.order, slab.grid.order);
  EXPECT_EQ(other.grid.cell_count(), slab.grid.cell_count());
  expect_same_mesh(other.mesh, slab.mesh);
  const double quantum = std::ldexp(1.0, quantum_exponent(slab));
  EXPECT_LE(quantum, 2e-4 * 15);  // direct light has a mean near 10, indirect near 1
  expect_near(slab.direct, other.direct, quantum);
  expect_near(slab.indirect, other.indirect, quantum);
}

TEST_P(SolutionIo, WritingAgainGivesTheSameBytes) {
  const Scene scene = small_scene();
  const Bytes once = written({scene, Solution{{make_slab(scene, 0, 4, {}, GetParam())}}, {}});
  EXPECT_EQ(written(read_back(once)), once);
}

TEST_P(SolutionIo, AnInstantOfAFileIsThatOfTheWhole) {
  const Scene scene = small_scene();
  for (const std::vector<double>& steps : {std::vector<double>{}, {0.5}, {0.5, 0.75, 2.499}}) {
    const Solution solution{
        {make_slab(scene, 0, 2.5, steps, GetParam()), make_slab(scene, 2.5, 4, {}, GetParam())}};
    const Bytes bytes = written({scene, solution, {}});
    const Stream whole = read_back(bytes);
    const TemporaryFile file(bytes);
    SolutionFile partial(file.path);
    EXPECT_EQ(partial.begin(), 0);
    EXPECT_EQ(partial.end(), 4);
    for (double time = -0.25; time < 4.5; time += 0.03125) {
      const VertexLight expected = light_at(whole.solution->slabs[slab_at(*whole.solution, time)], time);
      const VertexLight light = light_at(partial.slab_at(time), time);
      ASSERT_EQ(light.direct, expected.direct) << time;
      ASSERT_EQ(light.indirect, expected.indirect) << time;
    }
    const VertexLight expected = light_over(whole.solution->slabs[0], 1.1, 1.9);
    EXPECT_EQ(light_over(partial.slab_for(1.1, 1.9), 1.1, 1.9).direct, expected.direct);
  }
}

INSTANTIATE_TEST_SUITE_P(Orders, SolutionIo, testing::Values(1, 2, 3));

TEST(SolutionFileTest, AnInstantTouchesAFewBuckets) {
  const Scene scene = small_scene();
  const Slab slab = make_slab(scene, 0, 4);
  const TemporaryFile file(written({scene, Solution{{slab}}, {}}));
  SolutionFile partial(file.path);
  const size_t all = slab.direct.pieces.size(), some = partial.slab_at(1.3).direct.pieces.size();
  EXPECT_GT(some, 0u);
  EXPECT_LT(some, all / 2);
}

TEST(SolutionFileTest, AStreamWithoutSolutionIsRefused) {
  const TemporaryFile file(written({small_scene(), {}, {}}));
  EXPECT_THROW(SolutionFile(file.path), BadInput);
}

TEST(SolutionFileTest, ATruncatedFileIsRefused) {
  const Scene scene = small_scene();
  Bytes bytes = written({scene, Solution{{make_slab(scene, 0, 4)}}, {}});
  bytes.resize(bytes.size() - 1);
  const TemporaryFile file(bytes);
  EXPECT_THROW(SolutionFile(file.path), BadInput);
}

TEST(Buckets, AreRefusedWhenTruncatedAnywhere) {
  const Scene scene = small_scene();
  Slab slab = make_slab(scene, 0, 4, {}, 1);
  slab.direct = moving_light(slab.grid, 3, 1, 1);
  slab.direct.first_piece.resize(slab.mesh.vertices.size() + 1, slab.direct.first_piece.back());
  const std::vector<Chunk> chunks = encode_slab(scene, slab);
  for (size_t length = 0; length < chunks[0].content.size(); ++length)
    EXPECT_THROW(decode_slab(scene, ByteSpan(chunks[0].content).first(length), "test"), BadInput) << length;
  for (size_t length = 0; length < chunks[1].content.size(); ++length)
    EXPECT_THROW(decode_bucket(slab, ByteSpan(chunks[1].content).first(length), "test"), BadInput) << length;
}

TEST(Streams, UnknownAncillaryChunksAreCarriedThrough) {
  const Stream back = read_back(written({small_scene(), {}, {{chunk_type("note"), {1, 2, 3}}}}));
  ASSERT_EQ(back.others.size(), 1u);
  EXPECT_EQ(back.others[0].type, chunk_type("note"));
  EXPECT_EQ(back.others[0].content, (Bytes{1, 2, 3}));
}

TEST(Streams, UnknownCriticalChunksAreRefused) {
  const std::string fault = fault_of(written({small_scene(), {}, {{chunk_type("NEWS"), {1, 2, 3}}}}));
  EXPECT_NE(fault.find("chunk NEWS at byte "), std::string::npos) << fault;
}

TEST(Streams, ABucketWithoutItsSlabIsRefused) {
  EXPECT_NE(fault_of(written({small_scene(), {}, {{kDirectChunk, {}}}})).find("no slab"), std::string::npos);
}

TEST(Streams, AForeignIndexIsRefused) {
  EXPECT_NE(fault_of(written({small_scene(), {}, {{kIndexChunk, {0}}}})).find("not the index"),
            std::string::npos);
}

class Join : public testing::Test {
 protected:
  static Bytes joined(const std::vector<std::string>& paths) {
    Bytes bytes;
    StreamWriter writer([&bytes](ByteSpan more) { bytes.insert(bytes.end(), more.begin(), more.end()); });
    join(paths, "strad-join", writer);
    return bytes;
  }
  static std::string fault_of_joining(const Bytes& a, const Bytes& b) {
    const TemporaryFile first(a), second(b);
    try {
      joined({first.path, second.path});
      return "";
    } catch (const BadInput& fault) {
      return fault.what();
    }
  }
  const Scene scene_ = small_scene();
  const Slab early_ = make_slab(scene_, 0, 1.5), late_ = make_slab(scene_, 1.5, 4);
};

TEST_F(Join, IsExactInAnyOrder) {
  const TemporaryFile a(written({scene_, Solution{{early_}}, {}})),
      b(written({scene_, Solution{{late_}}, {}}));
  Stream both{scene_, Solution{{early_, late_}}, {}};
  both.scene.provenance = {"strad-join"};
  EXPECT_EQ(joined({a.path, b.path}), written(both));
  EXPECT_EQ(joined({b.path, a.path}), written(both));
}

TEST_F(Join, RefusesAGap) {
  const std::string fault = fault_of_joining(written({scene_, Solution{{early_}}, {}}),
                                             written({scene_, Solution{{make_slab(scene_, 2, 4)}}, {}}));
  EXPECT_NE(fault.find("a gap"), std::string::npos) << fault;
}

TEST_F(Join, RefusesAnOverlap) {
  const std::string fault = fault_of_joining(written({scene_, Solution{{early_}}, {}}),
                                             written({scene_, Solution{{make_slab(scene_, 1, 4)}}, {}}));
  EXPECT_NE(fault.find("an overlap"), std::string::npos) << fault;
}

TEST_F(Join, RefusesAnotherSceneAndSaysWhatDiffers) {
  Scene other = scene_;
  other.materials[0].reflectance.r = 0.25f;
  const std::string fault =
      fault_of_joining(written({scene_, Solution{{early_}}, {}}), written({other, Solution{{late_}}, {}}));
  EXPECT_NE(fault.find("in chunk MATL"), std::string::npos) << fault;
}

TEST_F(Join, RefusesAStreamWithoutSolution) {
  EXPECT_NE(fault_of_joining(written({scene_, Solution{{early_}}, {}}), written({scene_, {}, {}})), "");
}

}  // namespace
}  // namespace strad
