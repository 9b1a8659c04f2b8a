// OBJ files as scenes.
#include "import/obj/obj.h"

#include <algorithm>
#include <map>

#include "base/error.h"
#include "base/text.h"
#include "import/obj/file.h"
#include "import/obj/materials.h"
#include "import/polygonize.h"
#include "import/smooth_normals.h"

namespace strad {
namespace {

// Adds the faces of an OBJ file to a scene, as planar convex polygons.
class FaceAdder {
 public:
  FaceAdder(const ParsedObj& obj, const ObjScan& scan, std::string name, ImportReport* report, Scene* scene)
      : obj_(obj), scan_(scan), name_(std::move(name)), report_(report), scene_(scene), normals_(scene) {}
  void add(size_t face_number);
  // Smooths those that came without normals. REQUIRES: all faces were added.
  void smooth(double angle) {
    const auto in_group = [](uint32_t group) { return group > 0 && group != kNone; };
    if (angle > 0 || std::any_of(groups_.begin(), groups_.end(), in_group))
      smooth_by_faces({groups_, angle}, &normals_, scene_);
  }

 private:
  Polygon polygon_of(const ParsedObj::Face& face, const OutlinePiece& piece) const;
  bool give_normals(const ParsedObj::Face& face, const OutlinePiece& piece, uint32_t line, Polygon* polygon);
  const ParsedObj& obj_;
  const ObjScan& scan_;
  const std::string name_;
  ImportReport* report_;
  Scene* scene_;
  SmoothNormals normals_;
  std::vector<uint32_t> groups_;  // for smoothing, by polygon; none where the file has normals
  std::vector<Vec3> outline_;
  std::vector<OutlinePiece> pieces_;
};

Polygon FaceAdder::polygon_of(const ParsedObj::Face& face, const OutlinePiece& piece) const {
  Polygon polygon;
  polygon.material = face.material;
  polygon.object = face.object;
  const ParsedObj::Corner* corners = &obj_.corners[face.first_corner];
  const bool textured = scene_->materials[face.material].texture != kNone;
  bool all_have_uvs = textured;
  for (uint32_t k = 0; k < face.corner_count; ++k) all_have_uvs = all_have_uvs && corners[k].uv != kNone;
  for (int k = 0; k < 4 && piece.corners[k] >= 0; ++k) {
    polygon.corners[k] = corners[piece.corners[k]].vertex;
    if (all_have_uvs) polygon.uvs[k] = corners[piece.corners[k]].uv;
  }
  return polygon;
}

// Whether the file has normals at all corners of the piece.
bool FaceAdder::give_normals(const ParsedObj::Face& face, const OutlinePiece& piece, uint32_t line,
                             Polygon* polygon) {
  Vec3 given[4];
  for (int k = 0; k < polygon->corner_count(); ++k) {
    const uint32_t normal = obj_.corners[face.first_corner + static_cast<size_t>(piece.corners[k])].normal;
    if (normal == kNone || !(length(obj_.normals[normal]) > 0)) return false;
    given[k] = obj_.normals[normal];
  }
  if (normals_.set(polygon, given) == NormalsGiven::kContrary)
    report_->add("face whose normals lie on both of its sides is drawn flat", name_, line);
  return true;
}

void FaceAdder::add(size_t face_number) {
  const ParsedObj::Face& face = obj_.faces[face_number];
  const uint32_t line = scan_.face_lines[face_number];
  outline_.clear();
  pieces_.clear();
  for (uint32_t k = 0; k < face.corner_count; ++k)
    outline_.push_back(scene_->vertices[obj_.corners[face.first_corner + k].vertex]);
  const Outline kind = polygonize(outline_, &pieces_);
  if (kind == Outline::kDegenerate) report_->add("degenerate face left out", name_, line);
  if (kind == Outline::kCrossing) report_->add("face that crosses itself left out in part", name_, line);
  for (const OutlinePiece& piece : pieces_) {
    Polygon polygon = polygon_of(face, piece);
    const bool given = give_normals(face, piece, line, &polygon);
    scene_->polygons.push_back(polygon);
    groups_.push_back(given ? kNone : scan_.face_groups[face_number]);
    if (scene_->materials[face.material].texture != kNone && scene_->polygons.back().uvs[0] == kNone)
      report_->add("face of a material with a texture has no texture coordinates", name_, line);
  }
}

// Gives polygons whose texture is scaled or moved coordinates of their own.
void place_textures(const std::vector<TexturePlacement>& placements, Scene* scene) {
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> placed;  // by material and coordinate
  for (Polygon& polygon : scene->polygons) {
    const TexturePlacement& place = placements[polygon.material];
    if (place.is_usual()) continue;
    for (uint32_t& uv : polygon.uvs) {
      if (uv == kNone) continue;
      const auto [known, is_new] =
          placed.insert({{polygon.material, uv}, static_cast<uint32_t>(scene->uvs.size())});
      if (is_new) {
        const Vec2 at = scene->uvs[uv];
        scene->uvs.push_back({at.x * place.scale.x + place.offset.x, at.y * place.scale.y + place.offset.y});
      }
      uv = known->second;
    }
  }
}

// Materials and objects that no polygon uses are dropped.
void drop_unused_names(Scene* scene) {
  std::vector<uint32_t> material_at(scene->materials.size(), kNone), object_at(scene->objects.size(), kNone);
  for (const Polygon& polygon : scene->polygons)
    material_at[polygon.material] = object_at[polygon.object] = 0;
  const auto compact = [](auto* items, std::vector<uint32_t>* place) {
    uint32_t kept = 0;
    for (size_t i = 0; i < place->size(); ++i) {
      if ((*place)[i] == kNone) continue;
      if (kept != i) (*items)[kept] = std::move((*items)[i]);
      (*place)[i] = kept++;
    }
    items->resize(kept);
  };
  compact(&scene->materials, &material_at);
  compact(&scene->objects, &object_at);
  for (Polygon& polygon : scene->polygons) {
    polygon.material = material_at[polygon.material];
    polygon.object = object_at[polygon.object];
  }
}

}  // namespace

ObjFile read_obj(const std::string& path, const ImportOptions& options, ImportReport* report) {
  ObjFile file{path, text_name(path), {}, {}};
  file.scan = scan_obj(read_text(path), file.name, options, report);
  file.obj = parse_clean_obj(file.scan.clean);
  if (file.obj.vertices.size() != file.scan.vertex_count ||
      file.obj.faces.size() != file.scan.face_lines.size())
    throw BadInput(file.name + ": tinyobjloader lost vertices or faces");
  file.scan.clean.clear();
  return file;
}

Scene scene_of(ObjFile file, const std::vector<uint32_t>& bodies, std::vector<Body> moving,
               const ImportOptions& options, ImportReport* report) {
  Scene scene;
  const std::vector<TexturePlacement> placements =
      load_obj_materials(file.scan, file.path, options, report, &scene);
  for (size_t i = 0; i < file.scan.objects.size(); ++i)
    scene.objects.push_back({file.scan.objects[i].name, bodies.empty() ? 0 : bodies[i]});
  for (Body& body : moving) scene.bodies.push_back(std::move(body));
  FaceAdder adder(file.obj, file.scan, file.name, report, &scene);
  scene.vertices = std::move(file.obj.vertices);
  for (size_t face = 0; face < file.obj.faces.size(); ++face) adder.add(face);
  adder.smooth(options.smooth);
  scene.uvs = std::move(file.obj.uvs);
  place_textures(placements, &scene);
  drop_unused_names(&scene);
  return scene;
}

Scene import_obj(const std::string& path, const ImportOptions& options, ImportReport* report) {
  ObjFile file = read_obj(path, options, report);
  const std::string name = file.name;
  return finish_import(scene_of(std::move(file), {}, {}, options, report), options, name, report);
}

}  // namespace strad
