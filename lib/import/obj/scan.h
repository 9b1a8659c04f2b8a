// The guard before tinyobjloader: reads an OBJ file strictly and hands on only what can be taken at its word.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "import/import.h"

namespace strad {

struct ObjScan {
  // The same scene with nothing left to be misread: v, vt and f with absolute indices; `o N` and `usemtl N`
  // name by place in the lists below. One face a line of face_lines.
  std::string clean;
  std::vector<uint32_t> face_lines;
  size_t vertex_count = 0, uv_count = 0;

  struct Named {
    std::string name;
    uint32_t line = 0;  // where it is first used
  };
  std::vector<Named> objects;    // "object", "group" or "object/group"
  std::vector<Named> materials;  // names used by faces; "" where none is in force
  std::vector<Named> libraries;  // what follows each mtllib
};

// `name` is the file's in errors. Throws BadInput at the first fault.
ObjScan scan_obj(std::string_view text, const std::string& name, const ImportOptions& options,
                 ImportReport* report);

}  // namespace strad
