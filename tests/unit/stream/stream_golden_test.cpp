// Version 1 of the stream, byte for byte: files written by earlier versions must stay readable.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iomanip>

#include "base/error.h"
#include "solution/stream_io.h"
#include "solve/mesh/mesh_builder.h"

namespace strad {
namespace {

const char* const kPath = STRAD_SOURCE_DIR "/tests/golden/stream-1.hex";

// A triangle and a quad, a turning body, each kind of light, a solution with one split and three pieces.
Stream golden_stream() {
  Stream stream;
  Scene& scene = stream.scene;
  scene.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
  scene.uvs = {{0, 0}, {1, 0}, {0, 1}};
  scene.polygons = {{{0, 1, 2, 3}, {kNone, kNone, kNone, kNone}, 0, 0},
                    {{0, 1, 4, kNone}, {0, 1, 2, kNone}, 1, 1}};
  scene.objects = {{"floor", 0}, {"tent", 1}};
  scene.materials = {{"white", {0.75f, 0.75f, 0.75f}, {}, kNone}, {"lamp", {0.5f, 0.5f, 0.5f}, {3, 2, 1}, 0}};
  scene.textures = {{"wood.png", 1, 2, {10, 20, 30, 40, 50, 60}}};
  scene.end = 2;
  scene.bodies.push_back({"crane", 0, {}, {0, 1, 0}, Ease::kLinear, {}, {"tent"}});
  scene.bodies[1].keys = {{0, {}, 0, false, {}}, {2, {1, 0, 0}, 0.5, false, {}}};
  scene.spots = {{"key", 1, 0.25, 0.5, {{0, {0, 0, 2}, {0, 0, 0}, {30, 30, 30}}}}};
  scene.glows = {{1, {{0, 1}, {2, 0.5f}}}};
  scene.cameras = {{"main", {{0, {0, -3, 1}, {0, 0, 0}, {0, 0, 1}, 0.75}}}};
  scene.provenance = {"strad-import 0.1.0 tent.obj"};
  stream.others = {{chunk_type("note"), {'h', 'i'}}};

  Slab slab;
  slab.grid = make_time_grid(0, 2, {1}, 2, 8);
  MeshBuilder builder(scene);
  builder.face(0, 0);
  builder.face(1, 1);
  builder.split(0);
  slab.mesh = builder.take();
  slab.direct.order = slab.indirect.order = 2;
  slab.direct.first_piece.assign(slab.mesh.vertices.size() + 1, 2);
  slab.direct.first_piece[0] = 0;
  slab.direct.pieces = {{0, 1}, {2, 0}};
  slab.direct.coefficients = {{8, 4, 2}, {8, 4, 2}, {0.5f, 0.5f, 0.5f}, {-0.25f, 0, 1}};
  slab.indirect.first_piece.assign(slab.mesh.vertices.size() + 1, 0);
  slab.indirect.first_piece.back() = 1;
  slab.indirect.pieces = {{3, 0}};
  slab.indirect.coefficients = {{1, 1, 1}, {2, 2, 2}};
  stream.solution = Solution{{slab}};
  return stream;
}

Bytes written(const Stream& stream) {
  Bytes bytes;
  StreamWriter writer([&bytes](ByteSpan more) { bytes.insert(bytes.end(), more.begin(), more.end()); });
  write_stream(stream, writer);
  return bytes;
}

// Lines of hexadecimal bytes; those that begin with # are comments.
Bytes golden_bytes() {
  std::ifstream file(kPath);
  Bytes bytes;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    for (size_t i = 0; i + 1 < line.size(); i += 2)
      bytes.push_back(static_cast<uint8_t>(std::stoul(line.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

void renew(const Bytes& bytes) {
  std::ofstream file(kPath);
  file << "# Stream of version 1, made by `STRAD_RENEW=1 ctest --test-dir build -R stream_golden_test` with "
          "zstd 1.5.4.\n"
          "# Renew it only when compression changes; when the format changes, raise the version, add a "
          "file.\n";
  file << std::hex << std::setfill('0');
  for (size_t i = 0; i < bytes.size(); ++i)
    file << std::setw(2) << int{bytes[i]} << (i % 32 == 31 || i + 1 == bytes.size() ? "\n" : "");
}

TEST(GoldenStream, IsWrittenToTheByte) {
  const Bytes bytes = written(golden_stream());
  if (std::getenv("STRAD_RENEW")) renew(bytes);
  EXPECT_EQ(bytes, golden_bytes());
}

TEST(GoldenStream, IsRead) {
  const Bytes bytes = golden_bytes();
  StreamReader reader(bytes, kPath);
  const Stream stream = read_stream(reader), expected = golden_stream();
  EXPECT_EQ(stream.scene.vertices, expected.scene.vertices);
  EXPECT_EQ(stream.scene.provenance, expected.scene.provenance);
  EXPECT_EQ(stream.others.at(0).content, (Bytes{'h', 'i'}));
  ASSERT_TRUE(stream.solution);
  const Slab &slab = stream.solution->slabs.at(0), &other = expected.solution->slabs[0];
  EXPECT_EQ(slab.direct.pieces, other.direct.pieces);
  EXPECT_EQ(slab.direct.coefficients, other.direct.coefficients);  // powers of two, so exact
  EXPECT_EQ(slab.indirect.first_piece, other.indirect.first_piece);
  EXPECT_EQ(slab.indirect.coefficients, other.indirect.coefficients);
}

TEST(GoldenStream, IsRefusedWithAnyByteChanged) {
  const Bytes bytes = golden_bytes();
  for (size_t i = 0; i < bytes.size(); ++i) {
    Bytes changed = bytes;
    changed[i] = static_cast<uint8_t>(changed[i] ^ 0x10);
    EXPECT_THROW(
        {
          StreamReader reader(changed, "test");
          read_stream(reader);
        },
        BadInput)
        << i;
  }
}

TEST(GoldenStream, IsRefusedWhenCutAnywhere) {
  const Bytes bytes = golden_bytes();
  for (size_t length = 0; length < bytes.size(); ++length)
    EXPECT_THROW(
        {
          StreamReader reader(ByteSpan(bytes).first(length), "test");
          read_stream(reader);
        },
        BadInput)
        << length;
}

}  // namespace
}  // namespace strad
