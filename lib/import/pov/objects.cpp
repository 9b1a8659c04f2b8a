// POV-Ray's objects, their modifiers, and the statements of a file.
#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "import/pov/csg.h"
#include "import/pov/implicit.h"
#include "import/pov/looks.h"
#include "import/pov/scene_reader.h"
#include "import/pov/shapes.h"
#include "import/pov/solids.h"
#include "import/unique_names.h"

namespace strad {
namespace {

bool is_object(std::string_view word) {
  return is_one_of(word, {"object",       "box",        "sphere",     "cylinder",        "cone",
                          "disc",         "plane",      "triangle",   "smooth_triangle", "polygon",
                          "mesh",         "mesh2",      "union",      "merge",           "torus",
                          "lathe",        "sor",        "prism",      "superellipsoid",  "text",
                          "intersection", "difference", "blob",       "quadric",         "cubic",
                          "quartic",      "poly",       "isosurface", "bicubic_patch"});
}

bool is_unknown_object(std::string_view word) {
  return is_one_of(word, {"height_field", "julia_fractal", "lemon", "light_group", "ovus", "parametric",
                          "polynomial", "sphere_sweep"});
}

size_t bytes_of(const PovObject& object) {
  size_t bytes = sizeof object + object.points.size() * sizeof(Vec3) + object.uvs.size() * sizeof(Vec2) +
                 object.lights.size() * sizeof(PovLight) + object.shapes.size() * sizeof(uint32_t) +
                 (object.problems.size() + object.notes.size()) * sizeof(PovProblem);
  for (const std::string& part : object.parts) bytes += sizeof(std::string) + part.size();
  for (const PovFacet& facet : object.facets)
    bytes += sizeof facet + (facet.corners.size() + facet.uvs.size()) * sizeof(uint32_t);
  return bytes;
}

// Adds `child` to a compound object. `name`: that of its declaration, or empty.
void add_child(PovObject* object, UniqueNames* names, const PovObject& child, const std::string& name) {
  const auto first_point = static_cast<uint32_t>(object->points.size());
  const auto first_uv = static_cast<uint32_t>(object->uvs.size());
  for (const uint32_t shape : child.shapes) object->shapes.push_back(first_point + shape);
  object->points.insert(object->points.end(), child.points.begin(), child.points.end());
  object->uvs.insert(object->uvs.end(), child.uvs.begin(), child.uvs.end());
  std::vector<uint32_t> part_of(child.parts.size(), 0);
  const std::string own = name.empty() ? "" : names->unique(name);
  for (size_t i = 0; i < child.parts.size(); ++i) {
    const std::string& part = child.parts[i];
    if (own.empty() && part.empty()) continue;  // belongs to the object itself
    part_of[i] = static_cast<uint32_t>(object->parts.size());
    object->parts.push_back(own.empty() ? names->unique(part) : part.empty() ? own : own + "/" + part);
  }
  for (PovFacet facet : child.facets) {
    for (uint32_t& corner : facet.corners) corner += first_point;
    for (uint32_t& uv : facet.uvs) uv += first_uv;
    facet.part = part_of[facet.part];
    object->facets.push_back(std::move(facet));
  }
  object->lights.insert(object->lights.end(), child.lights.begin(), child.lights.end());
  object->problems.insert(object->problems.end(), child.problems.begin(), child.problems.end());
  object->notes.insert(object->notes.end(), child.notes.begin(), child.notes.end());
  object->endless = object->endless || child.endless;
  if (child.solid.kind != PovSolid::kNothing) object->solid.parts.push_back(child.solid);
}

}  // namespace

std::any PovSceneReader::describe(std::string_view word) {
  if (is_object(word) || is_unknown_object(word)) return std::make_shared<const PovObject>(object());
  if (in_.take_if("texture")) return layers(texture_block(default_texture_));
  if (in_.take_if("material")) return material_block(default_texture_);
  if (in_.take_if("pigment")) return pigment_block(default_texture_.pigment);
  if (in_.take_if("finish")) return finish_block(default_texture_.finish);
  if (is_one_of(word, {"color_map", "colour_map", "pigment_map", "texture_map"})) return map_block();
  if (in_.take_if("transform")) return transform_block();
  if (in_.take_if("light_source")) return light_block();
  if (in_.take_if("camera")) return camera_block();
  if (PovTransform one; transformation(&one)) return one;
  return {};
}

// Materials, parts and lights keep the names of their declarations.
void PovSceneReader::name_declared(const std::string& name, std::any* value) {
  if (auto* texture = std::any_cast<PovTexture>(value)) texture->name = name;
  if (auto* pigment = std::any_cast<PovPigment>(value)) pigment->name = name;
  if (auto* light = std::any_cast<PovLight>(value)) light->name = name;
  if (auto* camera = std::any_cast<PovCamera>(value)) camera->name = name;
}

void PovSceneReader::read(const std::string& path) {
  in_.open(path);
  while (in_.peek().kind != PovKind::kEnd) statement();
  judge_sky();
}

void PovSceneReader::statement() {
  const PovPlace at = in_.place();
  if (in_.take_if(";")) return;
  if (in_.peek().kind != PovKind::kWord) in_.fail_expected("an object, a light or a directive");
  const std::string word(in_.peek().text);
  if (is_object(word) || is_unknown_object(word)) {
    std::string name;
    PovObject made = object(&name);
    pov_make_pending(&made, {}, cells());
    const PovSurfacePointer plain = surface_of(default_texture_);
    for (PovFacet& facet : made.facets)
      if (!facet.surface) facet.surface = plain;
    placed_.push_back({name, std::move(made)});
  } else if (in_.take_if("light_source")) {
    PovObject carrier;
    carrier.place = at;
    carrier.lights.push_back(light_block());
    placed_.push_back({"light_source", std::move(carrier)});
  } else if (in_.take_if("camera")) {
    camera_ = camera_block();
  } else if (in_.take_if("default")) {  // an old form of #default
    default_block();
  } else if (!statement_of_air(word, at)) {
    if (!options_.skip_unknown) in_.fail_expected("an object, a light or a directive");
    refuse({in_quotes(word), at}, options_, report_);
    in_.skip_item();
  }
}

bool PovSceneReader::object_is_next() {
  return in_.peek().kind == PovKind::kWord &&
         (is_object(in_.peek().text) || is_unknown_object(in_.peek().text));
}

PovObject PovSceneReader::object(std::string* name) {
  const PovInterpreter::Deeper deeper(&in_);
  const PovPlace at = in_.place();
  const std::string kind(in_.take().text);
  PovObject made;
  made.place = at;
  if (is_unknown_object(kind)) {
    in_.skip_block();
    made.problems.push_back({kind, at});
  } else {
    in_.expect("{");
    std::string declared;
    if (auto known = in_.named<std::shared_ptr<const PovObject>>(&declared)) {
      made = **known;
      for (PovLight& light : made.lights)
        if (light.name.empty()) light.name = declared;
    } else {
      made = shape(kind, &declared);
    }
    made.place = at;
    modifiers(&made);
    if (name) *name = declared.empty() ? kind : declared;
  }
  in_.charge(bytes_of(made));
  return made;
}

PovObject PovSceneReader::shape(const std::string& kind, std::string* name) {
  if (kind == "box") {
    const Vec3 corner = in_.vector();
    in_.skip_comma();
    return pov_box(corner, in_.vector());
  }
  if (kind == "sphere") return sphere_shape();
  if (kind == "cylinder" || kind == "cone") return cone_shape(kind == "cylinder");
  if (kind == "disc") return disc_shape();
  if (kind == "plane") return plane_shape();
  if (kind == "triangle" || kind == "smooth_triangle") return triangle_shape(kind == "smooth_triangle");
  if (kind == "polygon") return polygon_shape();
  if (kind == "mesh") return mesh_shape();
  if (kind == "mesh2") return mesh2_shape();
  if (kind == "union" || kind == "merge") return union_shape();
  if (kind == "torus") return torus_shape();
  if (kind == "lathe") return lathe_shape();
  if (kind == "sor") return sor_shape();
  if (kind == "prism") return prism_shape();
  if (kind == "superellipsoid") return superellipsoid_shape();
  if (kind == "text") return text_shape();
  if (is_one_of(kind, {"quadric", "cubic", "quartic", "poly"})) return polynomial_shape(kind);
  if (kind == "blob") return blob_shape();
  if (kind == "isosurface") return isosurface_shape();
  if (kind == "bicubic_patch") return patch_shape();
  if (kind == "intersection" || kind == "difference") return intersection_shape(kind == "difference");
  // object { ... } holds a light or another object.
  PovObject made;
  if (auto light = in_.named<PovLight>(name)) {
    made.lights.push_back(*light);
    made.lights.back().name = *name;
    return made;
  }
  if (in_.take_if("light_source")) {
    made.lights.push_back(light_block());
    return made;
  }
  if (!object_is_next()) in_.fail_expected("an object");
  return object();
}

PovObject PovSceneReader::union_shape() {
  PovObject made;
  made.compound = true;
  made.shapes.clear();
  made.solid.kind = PovSolid::kUnion;
  UniqueNames names;
  while (in_.peek().kind == PovKind::kWord) {
    if (is_object(in_.peek().text) || is_unknown_object(in_.peek().text)) {
      const bool may_be_named = in_.next_is("object");
      std::string name;
      PovObject child = object(&name);
      pov_make_pending(&child, {}, cells());
      add_child(&made, &names, child, may_be_named && name != "object" ? name : "");
    } else if (in_.take_if("light_source")) {
      made.lights.push_back(light_block());
    } else {
      break;
    }
  }
  return made;
}

// clipped_by { objects }, of a plane also bounded_by. Later transformations move what is left as a whole.
void PovSceneReader::clip(PovObject* object, Modifiers* modifiers) {
  const PovPlace at = in_.place();
  in_.take();
  in_.expect("{");
  if (!object_is_next()) in_.fail_expected("an object that clips");
  std::vector<PovSolid> solids;
  PovObject carrier;
  for (PovObject& bounds : children(&carrier)) {
    pov_make_pending(&bounds, {}, cells());
    object->problems.insert(object->problems.end(), bounds.problems.begin(), bounds.problems.end());
    if (bounds.solid.kind != PovSolid::kNothing) solids.push_back(std::move(bounds.solid));
  }
  in_.expect("}");
  move_object(object, modifiers->transform);
  modifiers->transform = {};
  // A little more than what is wanted: where the grid ends, the surface is closed.
  Box wanted;
  for (const PovSolid& solid : solids) wanted.add(box_of_hulls(settled(solid)));
  if (!wanted.empty()) {
    const Vec3 margin = 0.05 * (wanted.upper - wanted.lower);
    wanted.add(wanted.lower - margin);
    wanted.add(wanted.upper + margin);
  }
  pov_make_pending(object, wanted, cells());
  pov_clip(object, solids, cuts_);
  if (object->facets.empty()) object->notes.push_back({"object outside what clips it left out", at});
}

bool PovSceneReader::modifier(Modifiers* modifiers, PovObject* object) {
  const PovPlace at = in_.place();
  PovTexture base = modifiers->texture.value_or(default_texture_);
  if (transformation(&modifiers->transform)) return true;
  if (in_.take_if("texture")) {
    const PovTexture texture = texture_block(default_texture_);
    modifiers->texture = modifiers->textured ? layered(texture, *modifiers->texture) : texture;
    modifiers->textured = true;
  } else if (in_.take_if("material")) {
    modifiers->texture = material_block(default_texture_);
  } else if (in_.take_if("pigment")) {
    base.name.clear();
    base.place = at;
    base.pigment = pigment_block(default_texture_.pigment);
    modifiers->texture = base;
  } else if (in_.take_if("finish")) {
    base.place = at;
    base.finish = finish_block(default_texture_.finish);
    modifiers->texture = base;
  } else if (in_.take_if("no_shadow")) {
    modifiers->no_shadow = true;
  } else if (in_.take_if("no_image")) {
    object->problems.push_back({"no_image", at});
  } else if (in_.next_is("clipped_by") ||
             ((object->endless || object->pending) && in_.next_is("bounded_by"))) {
    clip(object, modifiers);
  } else if (in_.take_if("inverse")) {
    modifiers->inverse = !modifiers->inverse;
  } else if (in_.next_is("hollow") || in_.next_is("no_reflection") || in_.next_is("double_illuminate") ||
             in_.next_is("sturm") || in_.next_is("hierarchy") || in_.next_is("split_union") ||
             in_.next_is("uv_mapping") || in_.next_is("smooth") || in_.next_is("no_radiosity")) {
    in_.take();
    if (in_.expression_is_next()) in_.numbers();
  } else if (in_.take_if("interior")) {
    modifiers->ior = interior_ior();
  } else if (in_.next_is("normal") || in_.next_is("interior_texture") || in_.next_is("bounded_by") ||
             in_.next_is("photons") || in_.next_is("radiosity") || in_.next_is("inside_vector")) {
    in_.skip_item();
  } else {
    return false;
  }
  return true;
}

void PovSceneReader::modifiers(PovObject* object) {
  Modifiers found;
  while (!in_.take_if("}")) {
    if (modifier(&found, object)) continue;
    if (in_.peek().kind != PovKind::kWord) in_.fail_expected("an object's modifier or }");
    object->problems.push_back({"object modifier " + in_quotes(in_.peek().text), in_.place()});
    in_.skip_item();
  }
  finish_object(object, found);
}

void PovSceneReader::finish_object(PovObject* object, const Modifiers& modifiers) {
  move_object(object, modifiers.transform);
  if (modifiers.inverse) *object = pov_inverse(std::move(*object));
  for (PovFacet& facet : object->facets) facet.no_shadow = facet.no_shadow || modifiers.no_shadow;
  if (!modifiers.texture) return;
  PovTexture texture = *modifiers.texture;
  texture.ior = modifiers.ior.value_or(texture.ior);
  const PovSurfacePointer surface = surface_of(texture);
  for (PovFacet& facet : object->facets)
    if (!facet.surface || !object->compound) facet.surface = surface;
}

}  // namespace strad
