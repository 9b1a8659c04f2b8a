// Reads POV-Ray's triangles, polygons and meshes.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "import/pov/scene_reader.h"
#include "import/pov/shapes.h"

namespace strad {
namespace {

// Adds a triangle that is wound as in POV-Ray: clockwise seen from outside, in coordinates of a right-handed
// space.
void add_triangle(PovObject* object, uint32_t a, uint32_t b, uint32_t c, PovSurfacePointer surface) {
  PovFacet facet;
  facet.corners = {a, c, b};
  facet.surface = std::move(surface);
  object->facets.push_back(std::move(facet));
}

std::array<int, 3> triple_of(const PovNumbers& found, const PovPlace& at) {
  std::array<int, 3> indices{};
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(found[i]) < 1e9)) fail_at(at.file, at.line, "an index is too large");
    indices[static_cast<size_t>(i)] = static_cast<int>(found[i]);
  }
  return indices;
}

}  // namespace

// Corners a, b, c; of a smooth triangle each is followed by its normal.
PovObject PovSceneReader::triangle_shape(bool smooth) {
  PovObject made;
  std::vector<Vec3> normals;
  for (int i = 0; i < 3; ++i) {
    made.points.push_back(in_.vector());
    in_.skip_comma();
    if (smooth) normals.push_back(in_.vector()), in_.skip_comma();
  }
  add_triangle(&made, 0, 1, 2, nullptr);
  if (smooth) made.facets.back().normals = {normals[0], normals[2], normals[1]};
  return made;
}

// A ring ends where its first point is repeated.
PovObject PovSceneReader::polygon_shape() {
  const PovPlace at = in_.place();
  const int count = in_.integer();
  in_.skip_comma();
  std::vector<std::vector<Vec3>> rings;
  bool open = false;
  for (int i = 0; i < count; ++i) {
    const Vec3 point = in_.vector();
    in_.skip_comma();
    if (!open) {
      rings.emplace_back().push_back(point);
      open = true;
    } else if (point == rings.back().front()) {
      open = false;
    } else {
      rings.back().push_back(point);
    }
  }
  if (rings.empty() ||
      std::any_of(rings.begin(), rings.end(), [](const auto& ring) { return ring.size() < 3; }))
    fail_at(at.file, at.line, "a polygon has a ring of fewer than 3 corners");
  return pov_polygon(rings);
}

PovObject PovSceneReader::mesh_shape() {
  PovObject made;
  made.compound = true;
  while (in_.next_is("triangle") || in_.next_is("smooth_triangle")) {
    const bool smooth = in_.take().text == "smooth_triangle";
    in_.expect("{");
    const PovObject triangle = triangle_shape(smooth);
    PovSurfacePointer surface;
    while (!in_.take_if("}")) {
      if (in_.take_if("texture")) {
        const auto known = in_.named<PovTexture>();  // `texture Name` without braces is an old form
        surface = surface_of(known ? *known : texture_block(default_texture_));
      } else if (in_.peek().kind == PovKind::kWord) {
        in_.skip_item();  // uv_vectors, texture_list
      } else {
        in_.fail_expected("texture or }");
      }
    }
    const auto first = static_cast<uint32_t>(made.points.size());
    made.points.insert(made.points.end(), triangle.points.begin(), triangle.points.end());
    add_triangle(&made, first, first + 1, first + 2, std::move(surface));
    made.facets.back().normals = triangle.facets.back().normals;
  }
  return made;
}

PovMeshLists PovSceneReader::mesh2_lists(PovObject* made) {
  PovMeshLists lists;
  lists.file = in_.place().file;
  while (in_.peek().kind == PovKind::kWord) {
    const std::string kind(in_.peek().text);
    const bool known = kind == "vertex_vectors" || kind == "uv_vectors" || kind == "texture_list" ||
                       kind == "face_indices" || kind == "uv_indices" || kind == "normal_vectors" ||
                       kind == "normal_indices";
    if (!known && kind == "inside_vector") {
      in_.skip_item();
      continue;
    }
    if (!known) break;
    in_.take();
    in_.expect("{");
    in_.integer();  // the stated count is not needed
    in_.skip_comma();
    while (!in_.take_if("}")) {
      if (kind == "vertex_vectors") {
        made->points.push_back(in_.vector());
      } else if (kind == "normal_vectors") {
        lists.normals.push_back(in_.vector());
      } else if (kind == "normal_indices") {
        lists.normal_faces.push_back(index_triple());
      } else if (kind == "uv_vectors") {
        made->uvs.push_back(in_.vector2());
      } else if (kind == "texture_list") {
        if (!in_.take_if("texture")) in_.fail_expected("texture or }");
        lists.surfaces.push_back(surface_of(texture_block(default_texture_)));
      } else if (kind == "uv_indices") {
        lists.uv_faces.push_back(index_triple());
      } else {
        mesh2_face(&lists);
      }
      in_.skip_comma();
    }
  }
  return lists;
}

std::array<int, 3> PovSceneReader::index_triple() {
  const PovPlace at = in_.place();
  return triple_of(promoted(in_.numbers(), 3), at);
}

// <a, b, c>, then nothing, the index of a texture, or three: one per corner.
void PovSceneReader::mesh2_face(PovMeshLists* lists) {
  PovMeshLists::Face face;
  face.line = in_.peek().line;
  face.corners = index_triple();
  in_.skip_comma();
  while (in_.expression_is_next() && !in_.next_is("<")) {
    const PovPlace at = in_.place();
    const PovNumbers found = in_.numbers();
    in_.skip_comma();
    if (found.size > 1) {  // the next face, as the name of a vector or a sum of some
      lists->faces.push_back(face);
      face = {triple_of(found, at), {}, 0, at.line};
      continue;
    }
    if (face.texture_count == 3) fail_at(at.file, at.line, "found a number, expected a face or }");
    face.textures[static_cast<size_t>(face.texture_count++)] = triple_of(found, at)[0];
  }
  lists->faces.push_back(face);
}

PovObject PovSceneReader::mesh2_shape() {
  PovObject made;
  made.compound = true;
  const PovMeshLists lists = mesh2_lists(&made);
  const auto check = [&lists](int index, size_t count, const char* what, uint32_t line) {
    if (index < 0 || static_cast<size_t>(index) >= count)
      fail_at(
          lists.file, line,
          std::string("face uses ") + what + " " + std::to_string(index) + " of " + std::to_string(count));
    return static_cast<uint32_t>(index);
  };
  const auto surface = [&](int index, uint32_t line) {
    return lists.surfaces[check(index, lists.surfaces.size(), "texture", line)];
  };
  for (size_t i = 0; i < lists.faces.size(); ++i) {
    const PovMeshLists::Face& face = lists.faces[i];
    const auto& t = face.textures;
    PovSurfacePointer of_face;
    if (face.texture_count == 3) {
      of_face = mean_of(surface(t[0], face.line), surface(t[1], face.line), surface(t[2], face.line));
    } else if (face.texture_count == 1) {
      of_face = surface(t[0], face.line);
    }
    std::array<uint32_t, 3> corners{}, uvs{};
    for (size_t k = 0; k < 3; ++k)
      corners[k] = check(face.corners[k], made.points.size(), "vertex", face.line);
    add_triangle(&made, corners[0], corners[1], corners[2], of_face);
    if (!lists.normals.empty()) {
      const auto& normal_face = i < lists.normal_faces.size() ? lists.normal_faces[i] : face.corners;
      std::array<Vec3, 3> n{};
      for (size_t k = 0; k < 3; ++k)
        n[k] = lists.normals[check(normal_face[k], lists.normals.size(), "normal", face.line)];
      made.facets.back().normals = {n[0], n[2], n[1]};
    }
    if (made.uvs.empty()) continue;
    const auto& uv_face = i < lists.uv_faces.size() ? lists.uv_faces[i] : face.corners;
    for (size_t k = 0; k < 3; ++k)
      uvs[k] = check(uv_face[k], made.uvs.size(), "texture coordinate", face.line);
    made.facets.back().uvs = {uvs[0], uvs[2], uvs[1]};
  }
  return made;
}

}  // namespace strad
