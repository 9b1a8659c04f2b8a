// Reads an OBJ file strictly, and rewrites it for tinyobjloader so that nothing in it can be misread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "import/import.h"

namespace strad {

struct ObjScan {
  // The same scene, simplified: v, vt, vn and f with absolute indices, and `o N` and `usemtl N`, where N is
  // an index into `objects` or `materials`. Each face has its line in face_lines, and its smoothing group.
  std::string clean;
  std::vector<uint32_t> face_lines, face_groups;
  size_t vertex_count = 0, uv_count = 0, normal_count = 0;

  struct Named {
    std::string name;
    uint32_t line = 0;  // where it is first used
  };
  std::vector<Named> objects;    // "object", "group" or "object/group"
  std::vector<Named> materials;  // names used by faces; "" for faces before any usemtl
  std::vector<Named> libraries;  // the rest of each mtllib line
};

// `name` is the file's in errors. Throws BadInput at the first fault.
ObjScan scan_obj(std::string_view text, const std::string& name, const ImportOptions& options,
                 ImportReport* report);

}  // namespace strad
