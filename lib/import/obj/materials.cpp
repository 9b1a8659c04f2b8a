// The materials that an OBJ file uses, read from its MTL files.
#include "import/obj/materials.h"

#include <algorithm>
#include <map>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "import/load_texture.h"
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
  uint32_t texture_of(const MtlMaterial& material);
  Material converted(const MtlMaterial& from);

  const std::string& path_;
  const std::string name_;
  const ImportOptions& options_;
  ImportReport* report_;
  Scene* scene_;
  std::map<std::string, MtlMaterial> known_;
  std::map<std::pair<std::string, bool>, uint32_t> texture_at_;  // by resolved path and whether it is clamped
  std::vector<std::string> read_;
  std::vector<TexturePlacement> placements_;
};

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

uint32_t MaterialLoader::texture_of(const MtlMaterial& material) {
  const std::string path = found_path(material.file, material.texture);
  const std::pair key{path, material.texture_clamp};
  if (const auto known = texture_at_.find(key); known != texture_at_.end()) return known->second;
  if (!file_exists(path)) {
    missing("texture " + in_quotes(path, path.size()) + " is missing", material.file, material.texture_line);
    return texture_at_[key] = kNone;
  }
  scene_->textures.push_back(
      load_texture({path, material.texture, false, material.file, material.texture_line}));
  scene_->textures.back().clamp = material.texture_clamp;
  return texture_at_[key] = static_cast<uint32_t>(scene_->textures.size() - 1);
}

Material MaterialLoader::converted(const MtlMaterial& from) {
  Material material;
  material.name = from.name;
  material.emission = from.emission;
  if (!from.texture.empty()) material.texture = texture_of(from);
  const bool textured = material.texture != kNone;
  if (from.reflectance_line > 0) {
    material.reflectance = limited_reflectance(from.reflectance, from.file, from.reflectance_line, report_);
  } else if (textured) {
    material.reflectance = {kMaxReflectance, kMaxReflectance, kMaxReflectance};
  }
  if (textured && is_black(material.reflectance))
    report_->add("map_Kd shows nothing where Kd is 0", from.file, from.texture_line);
  for (const MtlMaterial::Ignored& ignored : from.ignored)
    report_->add(ignored.what, from.file, ignored.line);
  return material;
}

void MaterialLoader::make(const ObjScan::Named& wanted) {
  if (const auto found = known_.find(wanted.name); found != known_.end()) {
    const MtlMaterial& material = found->second;
    scene_->materials.push_back(converted(material));
    placements_.push_back({material.texture_scale, material.texture_offset});
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
