// tinyobjloader's reading of text that scan_obj has checked and rewritten.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace strad {

struct ParsedObj {
  std::vector<Vec3> vertices;
  std::vector<Vec2> uvs;
  std::vector<Vec3> normals;  // of any length
  struct Corner {
    uint32_t vertex = kNone, uv = kNone, normal = kNone;
  };
  std::vector<Corner> corners;  // of all faces, one after another
  struct Face {
    size_t first_corner = 0;
    uint32_t corner_count = 0;
    uint32_t object = 0, material = 0;  // as in ObjScan
  };
  std::vector<Face> faces;
};

// REQUIRES: `clean` comes from scan_obj.
ParsedObj parse_clean_obj(const std::string& clean);

struct ParsedMaterial {
  Rgb reflectance, emission;
};

// Materials named 0, 1, 2... in that order. REQUIRES: `clean` comes from read_mtl.
std::vector<ParsedMaterial> parse_clean_mtl(const std::string& clean, size_t count);

}  // namespace strad
