// Puts what a POV-Ray file describes into a scene: surfaces, materials, the camera.
#include "import/pov/build.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "import/load_texture.h"
#include "import/polygonize.h"
#include "import/poses/few_scene_keys.h"
#include "scene/texture.h"

namespace strad {

uint32_t PovBuilder::vertex(Vec3 p) {
  const auto rounded = [](double x) {
    return static_cast<float>(x) + 0.0f;
  };  // to float, as in streams; + 0 turns -0 into 0
  p = placed(p);
  const std::array<float, 3> key{rounded(p.x), rounded(p.y), rounded(p.z)};
  const auto [found, is_new] = vertices_.insert({key, static_cast<uint32_t>(scene_.vertices.size())});
  if (is_new) scene_.vertices.push_back({key[0], key[1], key[2]});
  return found->second;
}

uint32_t PovBuilder::uv(Vec2 p) {
  scene_.uvs.push_back(p);
  return static_cast<uint32_t>(scene_.uvs.size() - 1);
}

uint32_t PovBuilder::texture_of(const PovImage& image, const PovPlace& place) {
  if (const auto known = textures_.find(image.path); known != textures_.end()) return known->second;
  if (!file_exists(image.path)) {
    const std::string what = "image " + in_quotes(image.path, image.path.size()) + " is missing";
    if (!options_.skip_missing) fail_at(image.place.file, image.place.line, what);
    report_->add(what + ": left out", place.file, place.line);
    return textures_[image.path] = kNone;
  }
  scene_.textures.push_back(
      load_texture({image.path, image.name, image.linear, image.place.file, image.place.line}));
  return textures_[image.path] = static_cast<uint32_t>(scene_.textures.size() - 1);
}

Rgb PovBuilder::mean_of(const PovImage& image, const PovPlace& place) {
  if (const auto known = image_means_.find(image.path); known != image_means_.end()) return known->second;
  const size_t before = scene_.textures.size();
  const uint32_t texture = texture_of(image, place);
  Rgb mean{1, 1, 1};
  if (texture != kNone) mean = mean_colour(scene_.textures[texture]);
  if (scene_.textures.size() > before) {  // only for its mean
    scene_.textures.pop_back();
    textures_.erase(image.path);
  }
  return image_means_[image.path] = mean;
}

namespace {

std::vector<float> numbers_of(const Material& material) {
  const Finish& finish = material.finish;
  std::vector<float> numbers{finish.ior, finish.fresnel ? 1.0f : 0.0f, finish.metallic ? 1.0f : 0.0f};
  for (const Rgb& rgb : {material.reflectance, material.emission, finish.specular, finish.transmission})
    numbers.insert(numbers.end(), {rgb.r, rgb.g, rgb.b});
  return numbers;
}

}  // namespace

uint32_t PovBuilder::material_of(const PovSurface& surface, const std::string& object_name, bool mapped) {
  const bool named = !surface.name.empty();
  if (const auto known = material_of_surface_.find({&surface, mapped});
      named && known != material_of_surface_.end())
    return known->second;
  for (const PovProblem& problem : surface.problems) refuse(problem, options_, report_);
  for (const PovProblem& note : surface.notes) report_->add(note.what, note.place.file, note.place.line);
  Material material;
  const std::string name = named ? surface.name : object_name;
  material.reflectance = surface.reflectance;
  if (surface.image && !mapped) {
    material.reflectance = material.reflectance * mean_of(*surface.image, surface.place);
    report_->add("image_map without uv_vectors is taken as its mean colour", surface.place.file,
                 surface.place.line);
  }
  for (int c = 0; c < 3; ++c) {
    if (!std::isfinite(material.reflectance[c]))
      fail_at(surface.place.file, surface.place.line, "a reflectance is not finite");
    if (material.reflectance[c] < 0)
      report_->add("negative reflectance is taken as 0", surface.place.file, surface.place.line);
    material.reflectance[c] = std::clamp(material.reflectance[c], 0.0f, 1.0f);
  }
  material.reflectance =
      limited_reflectance(material.reflectance, surface.place.file, surface.place.line, report_);
  const Varying varying = emission_of(surface);
  material.emission = overridden_emission(varying.emission, name, options_);
  if (!is_finite(material.emission))
    fail_at(surface.place.file, surface.place.line, "an emission is not finite");
  for (int c = 0; c < 3; ++c) {
    if (material.emission[c] >= 0) continue;
    report_->add("negative emission is taken as 0", surface.place.file, surface.place.line);
    material.emission[c] = 0;
  }
  if (surface.image && mapped) material.texture = texture_of(*surface.image, surface.place);
  if (is_black(material.emission) || is_black(surface.finish.transmission)) material.finish = surface.finish;
  limit_energy(&material, surface.place.file, surface.place.line, report_);
  const auto same_glow = std::find(glows_.begin(), glows_.end(), varying.keys);
  const auto glow = static_cast<size_t>(same_glow - glows_.begin());
  if (same_glow == glows_.end()) glows_.push_back(varying.keys);
  const auto [found, is_new] = materials_.insert(
      {{name, numbers_of(material), material.texture, glow}, static_cast<uint32_t>(scene_.materials.size())});
  if (is_new) {
    material.name = material_names_.unique(name);
    if (!varying.keys.empty()) scene_.glows.push_back({found->second, varying.keys});
    scene_.materials.push_back(material);
  }
  if (named) material_of_surface_[{&surface, mapped}] = found->second;
  return found->second;
}

// A glowing surface with no_shadow is the picture of a lamp around a light source. The light source lights
// the scene, so the surface must not.
bool PovBuilder::left_out(const PovFacet& facet, const PovObject& object) {
  if (facet.surface->clear) {
    report_->add("clear surface left out: all light passes", object.place.file, object.place.line);
    return true;
  }
  if (!facet.no_shadow) return false;
  if (is_black(facet.surface->emission)) {
    report_->add("no_shadow is ignored: all surfaces cast shadows", object.place.file, object.place.line);
    return false;
  }
  report_->add("glowing surface without shadow left out: its light comes from light sources",
               object.place.file, object.place.line);
  return true;
}

void PovBuilder::add_facet(const PovFacet& facet, const PovObject& object, uint32_t scene_object,
                           const std::string& object_name) {
  if (facet.corners.size() > kMaxCorners)
    fail_at(object.place.file, object.place.line,
            "a polygon has " + std::to_string(facet.corners.size()) + " corners, expected at most " +
                std::to_string(kMaxCorners));
  std::vector<Vec3> outline;
  std::vector<uint32_t> corners;
  for (const uint32_t corner : facet.corners) {
    if (!is_finite(object.points[corner]) || !(length(object.points[corner]) < 1e30))
      fail_at(object.place.file, object.place.line, "an object is not within the range of numbers");
    corners.push_back(vertex(object.points[corner]));
    outline.push_back(scene_.vertices[corners.back()]);
  }
  const size_t count = corners.size();
  // A mirrored outline runs the other way round.
  const auto at = [&](size_t i) { return mirror_ ? count - 1 - i : i; };
  if (mirror_) std::reverse(outline.begin(), outline.end());
  std::vector<OutlinePiece> pieces;
  const Outline kind = polygonize(outline, &pieces);
  if (kind == Outline::kDegenerate)
    report_->add("degenerate face left out", object.place.file, object.place.line);
  if (kind == Outline::kCrossing)
    report_->add("face that crosses itself left out in part", object.place.file, object.place.line);
  if (pieces.empty()) return;
  const uint32_t material = material_of(*facet.surface, object_name, !facet.uvs.empty());
  const bool textured = scene_.materials[material].texture != kNone;
  for (const OutlinePiece& piece : pieces) {
    Polygon polygon;
    Vec3 normals[4];
    polygon.object = scene_object;
    polygon.material = material;
    for (int k = 0; k < 4 && piece.corners[k] >= 0; ++k) {
      const size_t i = at(static_cast<size_t>(piece.corners[k]));
      polygon.corners[k] = corners[i];
      if (textured && !facet.uvs.empty()) polygon.uvs[k] = uv(object.uvs[facet.uvs[i]]);
      if (facet.normals.size() == facet.corners.size()) normals[k] = placed(facet.normals[i]);
    }
    const bool given =
        facet.normals.size() == facet.corners.size() &&
        std::all_of(normals, normals + polygon.corner_count(), [](Vec3 n) { return length(n) > 0; });
    if (given && normals_.set(&polygon, normals) == NormalsGiven::kContrary)
      report_->add("face whose normals lie on both of its sides is drawn flat", object.place.file,
                   object.place.line);
    scene_.polygons.push_back(polygon);
  }
}

// The object of the scene that a facet belongs to.
uint32_t PovBuilder::object_for(const PovFacet& facet, const PovObject& object, Parts* parts) {
  uint32_t body = 0;
  if (!parts->bodies.empty()) {
    const auto next = std::upper_bound(object.shapes.begin(), object.shapes.end(), facet.corners[0]);
    body = parts->bodies[static_cast<size_t>(next - object.shapes.begin()) - 1];
  }
  const auto [found, is_new] =
      parts->objects.insert({{facet.part, body}, static_cast<uint32_t>(scene_.objects.size())});
  if (!is_new) return found->second;
  const std::string& part = object.parts[facet.part];
  const bool has_others = std::any_of(parts->objects.begin(), parts->objects.end(), [&](const auto& other) {
    return other.first.first == facet.part && other.first.second != body;
  });
  std::string name = part.empty() ? parts->name : parts->name + "/" + part;
  if (has_others) name = object_names_.unique(name + "_part");
  scene_.objects.push_back({name, body});
  return found->second;
}

void PovBuilder::add_surfaces(const PovObject& object, Parts* parts) {
  for (const PovFacet& facet : object.facets)
    if (!left_out(facet, object)) add_facet(facet, object, object_for(facet, object, parts), parts->name);
}

void PovBuilder::add_object(const PovPlaced& placed, size_t index) {
  const PovObject& object = placed.object;
  for (const PovProblem& problem : object.problems) refuse(problem, options_, report_);
  for (const PovProblem& note : object.notes) report_->add(note.what, note.place.file, note.place.line);
  if (object.facets.empty()) return;
  Parts parts{object_names_.unique(placed.name), {}, {}};
  if (followed_)
    for (size_t shape = 0; shape < object.shapes.size(); ++shape)
      parts.bodies.push_back(body_of_piece(followed_->piece_of_shape(index, shape)));
  add_surfaces(object, &parts);
}

void PovBuilder::add_camera(const PovCamera& camera) {
  if (camera.problem) refuse(*camera.problem, options_, report_);
  scene_.cameras.push_back({camera.name.empty() ? "camera" : camera.name, {}});
  std::vector<CameraKey> keys{camera_key(camera, 0)};
  if (followed_ && !followed_->camera_history().empty()) {
    keys.clear();
    for (const PovCamera& now : followed_->camera_history())
      keys.push_back(camera_key(now, times_[keys.size()]));
  }
  scene_.cameras.back().keys = few_camera_keys(keys, box_of(scene_).diagonal());
}

}  // namespace strad
