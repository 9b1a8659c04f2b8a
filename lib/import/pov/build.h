// Puts what a POV-Ray file describes into a scene.
#pragma once

#include <array>
#include <bit>
#include <map>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "base/rng.h"
#include "import/import.h"
#include "import/pov/followed.h"
#include "import/pov/scene_values.h"
#include "import/smooth_normals.h"
#include "import/unique_names.h"

namespace strad {

class PovBuilder {
 public:
  // `mirror`: z becomes -z. `followed`: how things move; null for a still. `times`: of its frames, s.
  PovBuilder(const ImportOptions& options, ImportReport* report, bool mirror, const PovFollowed* followed,
             std::vector<double> times);

  // Adds the surfaces of an object of the first frame. Its name is `placed.name`, with a number behind it if
  // that is taken. Parts that do not move alike become objects of their own. `index`: of the object in its
  // frame.
  void add_object(const PovPlaced& placed, size_t index);
  // REQUIRES: all objects are added. The intensity of a light that does not fade depends on where they are.
  void add_light(const PovPlaced& placed, size_t index, size_t light);
  void add_camera(const PovCamera& camera);
  Scene take();

 private:
  // What a facet of an object becomes part of.
  struct Parts {
    std::string name;
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> objects;  // of the scene, by part and body
    std::vector<uint32_t> bodies;                               // by shape
  };
  struct Light {
    const PovLight& at_first;
    std::vector<PovLight> history;  // one a frame, or none
    std::vector<Rgb> intensities;   // W / sr on the axis, one a frame, or a single one
  };
  bool left_out(const PovFacet& facet, const PovObject& object);
  void add_surfaces(const PovObject& object, Parts* parts);
  uint32_t object_for(const PovFacet& facet, const PovObject& object, Parts* parts);
  void add_facet(const PovFacet& facet, const PovObject& object, uint32_t scene_object,
                 const std::string& object_name);
  uint32_t vertex(Vec3 p);
  uint32_t uv(Vec2 p);
  // `mapped`: it has texture coordinates; a picture without them is taken as its mean colour.
  uint32_t material_of(const PovSurface& surface, const std::string& object_name, bool mapped);
  Rgb mean_of(const PovImage& image, const PovPlace& place);
  uint32_t texture_of(const PovImage& image, const PovPlace& place);
  Vec3 placed(Vec3 v) const { return mirror_ ? Vec3{v.x, v.y, 0 - v.z} : v; }  // no -0

  Rgb intensity_of(const PovLight& light);
  void add_spot(const Light& light);
  void add_panel(const Light& light, uint32_t body, Vec3 front, bool is_lambertian);

  // What moves, in motion_build.cpp.
  struct Varying {
    Rgb emission;               // the brightest
    std::vector<GlowKey> keys;  // none: constant
  };
  uint32_t body_of_piece(uint32_t piece);
  uint32_t carrier_of(const Light& light) const;
  std::vector<SpotKey> spot_keys(const Light& light, uint32_t body) const;
  CameraKey camera_key(const PovCamera& camera, double time) const;
  Varying varying(const std::vector<Rgb>& emissions, const PovPlace& place) const;
  Varying emission_of(const PovSurface& surface) const;

  const ImportOptions& options_;
  ImportReport* report_;
  bool mirror_;
  const PovFollowed* followed_;
  std::vector<double> times_;
  std::vector<uint32_t> group_of_piece_, body_of_group_;
  Scene scene_;
  SmoothNormals normals_{&scene_};
  struct PointHash {
    size_t operator()(const std::array<float, 3>& p) const {
      return hash_of(std::bit_cast<uint32_t>(p[0]), std::bit_cast<uint32_t>(p[1]),
                     std::bit_cast<uint32_t>(p[2]));
    }
  };
  std::unordered_map<std::array<float, 3>, uint32_t, PointHash> vertices_;
  UniqueNames object_names_, material_names_, spot_names_;
  std::map<std::pair<const PovSurface*, bool>, uint32_t> material_of_surface_;  // mapped or not
  std::map<std::string, Rgb> image_means_;
  std::map<std::tuple<std::string, std::vector<float>, uint32_t, size_t>, uint32_t>
      materials_;                            // by name, numbers, texture and glow
  std::vector<std::vector<GlowKey>> glows_;  // those that materials have, each once; the first is none
  std::map<std::string, uint32_t> textures_;
  std::vector<PovSurfacePointer> panels_;
  std::map<const PovSurface*, Varying> panel_emissions_;
};

}  // namespace strad
