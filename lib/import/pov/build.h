// Puts what a POV-Ray file describes into a scene.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "import/import.h"
#include "import/pov/scene_values.h"
#include "import/pov/unique_names.h"

namespace strad {

class PovBuilder {
 public:
  // `mirror`: z becomes -z.
  PovBuilder(const ImportOptions& options, ImportReport* report, bool mirror)
      : options_(options), report_(report), mirror_(mirror) {}

  // Adds the surfaces of an object. Its name is `name`, with a number behind it if that is taken.
  void add_object(const std::string& name, const PovObject& object);
  // REQUIRES: all objects are added. The intensity of a light that does not fade depends on where they are.
  void add_light(const PovLight& light);
  void add_camera(const PovCamera& camera);
  Scene take() { return std::move(scene_); }

 private:
  bool left_out(const PovFacet& facet, const PovObject& object);
  void add_facet(const PovFacet& facet, const PovObject& object, uint32_t scene_object,
                 const std::string& object_name);
  uint32_t vertex(Vec3 p);
  uint32_t uv(Vec2 p);
  uint32_t material_of(const PovSurface& surface, const std::string& object_name);
  uint32_t texture_of(const PovImage& image, const PovPlace& place);
  Vec3 placed(Vec3 v) const { return mirror_ ? Vec3{v.x, v.y, -v.z} : v; }

  Rgb intensity_of(const PovLight& light);
  void add_spot(const PovLight& light, Rgb intensity);
  void add_panel(const PovLight& light, Rgb intensity, Vec3 front, bool is_lambertian);

  const ImportOptions& options_;
  ImportReport* report_;
  bool mirror_;
  Scene scene_;
  std::map<std::tuple<float, float, float>, uint32_t> vertices_;
  UniqueNames object_names_, material_names_, spot_names_;
  std::map<const PovSurface*, uint32_t> material_of_surface_;
  std::map<std::tuple<std::string, float, float, float, float, float, float, uint32_t>, uint32_t> materials_;
  std::map<std::string, uint32_t> textures_;
  std::vector<PovSurfacePointer> panels_;
};

}  // namespace strad
