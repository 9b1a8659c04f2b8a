// Damaged glTF and .ini files: each is accepted or refused with BadInput, none does anything else.
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "base/rng.h"
#include "import/gltf/gltf.h"
#include "import/pov/ini.h"

namespace strad {
namespace {

namespace fs = std::filesystem;

constexpr uint64_t kRounds = 3000;

void put_word(std::string* to, size_t word) {
  for (int i = 0; i < 4; ++i) to->push_back(static_cast<char>(word >> (8 * i) & 0xff));
}

// A binary glTF file: a triangle on a node that moves, with a light, a camera and a sparse accessor.
std::string small_glb() {
  std::string json =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,2]}],"nodes":[{"mesh":0,"children":[1]},)"
      R"({"mesh":0,"rotation":[0,0,0,1],"extensions":{"KHR_lights_punctual":{"light":0}}},{"camera":0,"matrix":)"
      R"([1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,)"
      R"("material":0}]}],"materials":[{"pbrMetallicRoughness":{"metallicFactor":0.5}}],"cameras":[{"type":)"
      R"("perspective","perspective":{"yfov":1,"znear":0.1}}],"extensions":{"KHR_lights_punctual":{"lights":)"
      R"([{"type":"point"}]}},"animations":[{"samplers":[{"input":2,"output":3,"interpolation":"STEP"}],)"
      R"("channels":[{"sampler":0,"target":{"node":1,"path":"translation"}}]}],"buffers":[{"byteLength":80}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6},{"buffer":0,)"
      R"("byteOffset":44,"byteLength":8},{"buffer":0,"byteOffset":52,"byteLength":24}],"accessors":[{"bufferView":0,)"
      R"("componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":1,"componentType":)"
      R"(5123},"values":{"bufferView":3}}},{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"},)"
      R"({"bufferView":2,"componentType":5126,"count":2,"type":"SCALAR"},{"bufferView":3,"componentType":5126,)"
      R"("count":2,"type":"VEC3"}]})";
  while (json.size() % 4) json += ' ';
  std::string bin;
  const auto put_floats = [&](std::initializer_list<float> values) {
    for (const float value : values) {
      uint32_t bits;
      std::memcpy(&bits, &value, 4);
      put_word(&bin, bits);
    }
  };
  put_floats({0, 0, 0, 1, 0, 0, 0, 1, 0});
  for (const int corner : {0, 1, 2, 0}) bin += std::string{static_cast<char>(corner), '\0'};
  put_floats({0, 1, 0, 0, 0, 2, 0, 0});
  bin.resize(80);
  std::string file = "glTF";
  put_word(&file, 2);
  put_word(&file, 12 + 8 + json.size() + 8 + bin.size());
  put_word(&file, json.size());
  file += "JSON" + json;
  put_word(&file, bin.size());
  return file + std::string("BIN\0", 4) + bin;
}

// One to four edits at places that depend on `seed` alone: bytes set, digits changed, parts cut out or
// repeated.
std::string damaged(std::string text, uint64_t seed) {
  for (uint64_t edit = 0; edit <= hash_of(seed) % 4 && !text.empty(); ++edit) {
    const uint64_t random = hash_of(seed, edit, 1);
    const size_t at = random % text.size(), length = 1 + (random >> 32) % 8;
    const char bytes[] = {'-', '9', '0', '"', ',', '\0', '\xff', '[', '}', 'e'};
    switch (random >> 40 & 7) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, text.substr(at, length));
        break;
      case 2:
        text.resize(at);
        break;
      case 3:
      case 4: {  // a number becomes another
        const size_t digit = text.find_first_of("0123456789", at);
        if (digit != std::string::npos) text[digit] = static_cast<char>('0' + (random >> 50) % 10);
        break;
      }
      default:
        text[at] = bytes[(random >> 50) % sizeof bytes];
    }
  }
  return text;
}

template <class Read>
uint64_t refused_of(const std::string& good, const fs::path& path, Read read) {
  uint64_t refused = 0;
  for (uint64_t round = 0; round < kRounds; ++round) {
    std::ofstream(path, std::ios::binary) << damaged(good, round);
    try {
      read(path.string());
    } catch (const BadInput&) {
      ++refused;
    }
  }
  fs::remove(path);
  return refused;
}

TEST(ImportFuzz, GltfIsAcceptedOrRefused) {
  const fs::path path = fs::path(testing::TempDir()) / "import_fuzz.glb";
  const auto read = [](const std::string& name) {
    ImportReport report;
    ImportOptions options;
    import_gltf(name, options, {}, &report);
    options.skip_unknown = true;
    import_gltf(name, options, {}, &report);
  };
  std::ofstream(path, std::ios::binary) << small_glb();
  EXPECT_NO_THROW(read(path.string()));
  const uint64_t refused = refused_of(small_glb(), path, read);
  EXPECT_GT(refused, kRounds / 2);
  EXPECT_LT(refused, kRounds);
}

TEST(ImportFuzz, IniIsAcceptedOrRefused) {
  const std::string good =
      "; comment\nInput_File_Name=a.pov\nInitial_Frame=1\nFinal_Frame=30\nInitial_Clock=0.5\nFinal_Clock=2\n"
      "Subset_Start_Frame=3\nSubset_End_Frame=0.8\nCyclic_Animation=on\nDeclare=Up=7\nWidth=320\n+H200 "
      "+L../x -KC\n";
  const uint64_t refused =
      refused_of(good, fs::path(testing::TempDir()) / "import_fuzz.ini", [](const std::string& name) {
        ImportReport report;
        const PovIni ini = read_pov_ini(name, {}, &report);
        EXPECT_LE(ini.animation.first, ini.animation.last);
        EXPECT_TRUE(!ini.animation.moves || ini.animation.last <= ini.animation.final_frame);
      });
  EXPECT_GT(refused, kRounds / 4);
  EXPECT_LT(refused, kRounds);
}

}  // namespace
}  // namespace strad
