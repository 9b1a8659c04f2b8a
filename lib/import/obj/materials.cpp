// The materials that an OBJ file uses, read from its MTL files.
#include "import/obj/materials.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "import/load_texture.h"
#include "import/obj/finish.h"
#include "import/obj/mtl.h"

namespace strad {
namespace {

class MaterialLoader {
 public:
  MaterialLoader(const std::string& path, const ImportOptions& options, ImportReport* report, Scene* scene)
      : path_(path), name_(text_name(path)), options_(options), report_(report), scene_(scene) {}

  void read_library(const ObjScan::Named& library);
  void make(const ObjScan::Named& wanted);
  std::vector<TexturePlacement> placements() { return std::move(placements_); }

 private:
  // See refuse_missing.
  void missing(const std::string& what, const std::string& file, uint32_t line) {
    refuse_missing(what, file, line, options_, report_);
  }
  void read_mtl_file(const std::string& reference, uint32_t line);
  void add(const MtlMaterial& material);
  std::optional<TextureSource> source_of(const MtlMaterial& material, const MtlPicture& picture);
  uint32_t texture_of(const MtlMaterial& material);
  void note_holes(const MtlMaterial& from, const Material& material);
  Material converted(const MtlMaterial& from);

  const std::string& path_;
  const std::string name_;
  const ImportOptions& options_;
  ImportReport* report_;
  Scene* scene_;
  std::map<std::string, MtlMaterial> known_;
  // By the resolved paths of its colours and its holes, and whether it is clamped.
  std::map<std::tuple<std::string, std::string, bool>, uint32_t> texture_at_;
  std::set<std::string> told_missing_;
  std::vector<std::string> read_;
  std::vector<TexturePlacement> placements_;
};

// The statement that says where on a polygon its texture is.
const MtlPicture& placed_by(const MtlMaterial& material) {
  return material.texture.file.empty() ? material.opacity : material.texture;
}

bool differ(Vec2 a, Vec2 b) { return a.x != b.x || a.y != b.y; }

// Files written under Windows separate folders by backslashes.
std::string found_path(const std::string& file, const std::string& reference) {
  std::string path = path_beside(file, reference);
  if (file_exists(path)) return path;
  std::string slashed = reference;
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  slashed = path_beside(file, slashed);
  return file_exists(slashed) ? slashed : path;
}

// The rest of a mtllib line is one name with blanks if there is such a file, else several names.
void MaterialLoader::read_library(const ObjScan::Named& library) {
  if (file_exists(found_path(path_, library.name))) return read_mtl_file(library.name, library.line);
  std::string_view rest = library.name;
  for (std::string_view word = next_word(&rest); !word.empty(); word = next_word(&rest))
    read_mtl_file(std::string(word), library.line);
}

void MaterialLoader::read_mtl_file(const std::string& reference, uint32_t line) {
  const std::string path = found_path(path_, reference);
  if (std::find(read_.begin(), read_.end(), path) != read_.end()) return;
  read_.push_back(path);
  if (!is_plain_file(path)) {  // a pipe or a device would have to be waited for
    const char* const fault = file_exists(path) ? " is no plain file" : " is missing";
    return missing("material file " + in_quotes(path, path.size()) + fault, name_, line);
  }
  for (const MtlMaterial& material : read_mtl(path)) add(material);
}

void MaterialLoader::add(const MtlMaterial& material) {
  const auto [first, is_new] = known_.insert({material.name, material});
  if (!is_new)
    report_->add("material " + in_quotes(material.name) + " is defined again: left out", material.file,
                 material.line);
}

std::optional<TextureSource> MaterialLoader::source_of(const MtlMaterial& material,
                                                       const MtlPicture& picture) {
  if (picture.file.empty()) return std::nullopt;
  const std::string path = found_path(material.file, picture.file);
  if (file_exists(path)) return TextureSource{path, picture.file, false, material.file, picture.line};
  if (told_missing_.insert(path).second)
    missing("texture " + in_quotes(path, path.size()) + " is missing", material.file, picture.line);
  return std::nullopt;
}

// A material with holes and no texture gets a white one.
uint32_t MaterialLoader::texture_of(const MtlMaterial& material) {
  const auto colours = source_of(material, material.texture), holes = source_of(material, material.opacity);
  if (!colours && !holes) return kNone;
  const std::tuple key{colours ? colours->path : "", holes ? holes->path : "", placed_by(material).clamp};
  if (const auto known = texture_at_.find(key); known != texture_at_.end()) return known->second;
  Texture texture = colours ? load_texture(*colours) : Texture{holes->name, 1, 1, {255, 255, 255}};
  if (holes) texture.opacity = load_opacity(*holes);
  texture.clamp = placed_by(material).clamp;
  scene_->textures.push_back(std::move(texture));
  return texture_at_[key] = static_cast<uint32_t>(scene_->textures.size() - 1);
}

Material MaterialLoader::converted(const MtlMaterial& from) {
  Material material;
  material.name = from.name;
  material.emission = from.emission;
  material.texture = texture_of(from);
  const bool textured = material.texture != kNone && !from.texture.file.empty();
  if (from.reflectance_line > 0) {
    material.reflectance = limited_reflectance(from.reflectance, from.file, from.reflectance_line, report_);
  } else if (textured) {
    material.reflectance = {kMaxReflectance, kMaxReflectance, kMaxReflectance};
  }
  if (textured && is_black(material.reflectance))
    report_->add("map_Kd shows nothing where Kd is 0", from.file, from.texture.line);
  note_holes(from, material);
  set_finish(from, &material, report_);
  std::vector<MtlMaterial::Ignored> all = from.ignored;
  if (!from.is_glass() && !from.is_mirror())
    all.insert(all.end(), from.of_finish.begin(), from.of_finish.end());
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.line < b.line; });
  for (const MtlMaterial::Ignored& ignored : all) report_->add(ignored.what, from.file, ignored.line);
  return material;
}

void MaterialLoader::note_holes(const MtlMaterial& from, const Material& material) {
  if (material.texture == kNone || scene_->textures[material.texture].opacity.values.empty()) return;
  const MtlPicture &colours = from.texture, &holes = from.opacity;
  const uint32_t line = holes.file.empty() ? colours.line : holes.line;
  if (!is_black(material.emission)) report_->add("a material that emits has no holes", from.file, line);
  if (colours.file.empty() || holes.file.empty()) return;
  if (differ(colours.scale, holes.scale) || differ(colours.offset, holes.offset) ||
      colours.clamp != holes.clamp)
    report_->add("map_d is placed as map_Kd is", from.file, line);
}

void MaterialLoader::make(const ObjScan::Named& wanted) {
  if (const auto found = known_.find(wanted.name); found != known_.end()) {
    const MtlMaterial& material = found->second;
    scene_->materials.push_back(converted(material));
    placements_.push_back({placed_by(material).scale, placed_by(material).offset});
    return;
  }
  placements_.emplace_back();
  const Material grey;
  if (wanted.name.empty()) {
    report_->add("face without a material takes reflectance 0.5", name_, wanted.line);
  } else {
    missing("material " + in_quotes(wanted.name) + " is not defined", name_, wanted.line);
  }
  scene_->materials.push_back(grey);
  scene_->materials.back().name = wanted.name.empty() ? "unnamed" : wanted.name;
}

}  // namespace

std::vector<TexturePlacement> load_obj_materials(const ObjScan& scan, const std::string& path,
                                                 const ImportOptions& options, ImportReport* report,
                                                 Scene* scene) {
  MaterialLoader loader(path, options, report, scene);
  for (const ObjScan::Named& library : scan.libraries) loader.read_library(library);
  for (const ObjScan::Named& wanted : scan.materials) loader.make(wanted);
  return loader.placements();
}

}  // namespace strad
