// Reads POV-Ray's textures, objects, lights and camera.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "import/import.h"
#include "import/pov/cut_cache.h"
#include "import/pov/language/interpreter.h"
#include "import/pov/scene_values.h"

namespace strad {

// The lists of a mesh2, except its points and texture coordinates.
struct PovMeshLists {
  struct Face {
    std::array<int, 3> corners{}, textures{};
    int texture_count = 0;  // 0, 1 or 3
    uint32_t line = 0;
  };
  std::vector<Face> faces;
  std::vector<std::array<int, 3>> uv_faces, normal_faces;
  std::vector<Vec3> normals;
  std::vector<PovSurfacePointer> surfaces;
  std::string file;
};

class PovSceneReader : private PovStatements {
 public:
  // The arguments must outlive the reader.
  // `cuts`: what was cut in other frames; may be null.
  PovSceneReader(const ImportOptions& options, const PovRun& run, PovFiles* files, ImportReport* report,
                 PovCutCache* cuts = nullptr)
      : options_(options), report_(report), cuts_(cuts), in_(options, run, files, report, this) {}

  using Placed = PovPlaced;

  // Reads the file at `path`. Throws IoError or BadInput.
  void read(const std::string& path);

  std::vector<Placed>& placed() { return placed_; }
  const std::optional<PovCamera>& camera() const { return camera_; }

  // What is finite in a scene, from which follows where planes are cut.
  struct Extent {
    Vec3 centre;
    double size = 1;
  };
  // Cuts what is endless. `extent`: that of the scene, which is found if it is not set.
  void cut_endless(std::optional<Extent>* extent);

 private:
  std::any describe(std::string_view word) override;
  PovNumbers measured(const std::string& name) override;  // in measures.cpp
  std::optional<Vec3> transformed(const std::any& thing, Vec3 vector) override;
  void name_declared(const std::string& name, std::any* value) override;
  void default_block() override;
  void statement();
  bool statement_of_air(const std::string& word, const PovPlace& at);
  void global_settings();
  Rgb plain_colour();
  void judge_sky();

  // Textures, in textures.cpp. Each function reads from the opening brace.
  PovTexture texture_block(const PovTexture& base);
  void texture_items(PovTexture* texture, const PovTexture& base, std::string_view end);
  PovTexture layers(PovTexture texture);
  PovFinish finish_block(const PovFinish& base);
  bool finish_light(PovFinish* finish);
  void mirror(PovFinish* finish);
  double interior_ior();
  PovTexture material_block(const PovTexture& base);
  PovSurfacePointer surface_of(const PovTexture& texture);
  static PovSurfacePointer mean_of(const PovSurfacePointer& a, const PovSurfacePointer& b,
                                   const PovSurfacePointer& c);

  // Pigments and patterns, in pigments.cpp.
  struct PovPattern {
    std::string word;  // of the pattern; empty if there is none
    PovPlace place;
    PovMap map;
    std::vector<std::pair<double, PovTexture>> list;  // with weights
    Vec3 brick{8, 3, 4.5};                            // POV-Ray's defaults
    double mortar = 0.5;
  };
  PovPigment pigment_block(const PovPigment& base);
  void pigment_items(PovPigment* pigment, std::string_view end);
  std::shared_ptr<const PovImage> image_block();
  PovMap map_block();
  void map_entry(PovMap* map, bool of_pigments, bool of_textures);
  void pattern_list(PovPattern* pattern, size_t count);
  bool pattern_item(PovPattern* pattern);
  std::optional<PovTexture> mean_of_pattern(PovPattern pattern, const std::string& of);

  // Objects, in objects.cpp, primitives.cpp and meshes.cpp.
  struct Modifiers {
    PovTransform transform;
    std::optional<PovTexture> texture;
    std::optional<double> ior;
    bool textured = false;  // by a `texture`: others are layers on it
    bool no_shadow = false, inverse = false;
  };
  PovObject object(std::string* name = nullptr);  // from the word that says its kind
  PovObject shape(const std::string& kind, std::string* name);
  PovObject sphere_shape();
  PovObject cone_shape(bool is_cylinder);
  PovObject disc_shape();
  PovObject plane_shape();
  PovObject triangle_shape(bool smooth);
  PovObject polygon_shape();
  PovObject union_shape();
  PovObject torus_shape();
  PovObject lathe_shape();
  PovObject sor_shape();
  PovObject prism_shape();
  PovObject superellipsoid_shape();
  PovObject text_shape();
  PovObject intersection_shape(bool difference);
  PovObject polynomial_shape(const std::string& kind);
  PovObject blob_shape();
  PovObject isosurface_shape();
  PovObject patch_shape();
  // Of the grid in which a surface is found: as fine as the sides of round objects.
  int cells() const { return options_.tessellate + options_.tessellate / 2; }
  std::vector<PovObject> children(PovObject* carrier);
  std::vector<Vec2> controls();
  bool object_is_next();
  PovObject mesh_shape();
  PovObject mesh2_shape();
  PovMeshLists mesh2_lists(PovObject* made);
  void mesh2_face(PovMeshLists* lists);
  std::array<int, 3> index_triple();
  void clip(PovObject* object, Modifiers* modifiers);
  void modifiers(PovObject* object);
  bool modifier(Modifiers* modifiers, PovObject* object);
  bool transformation(PovTransform* transform);  // takes one if it is next
  PovTransform transform_block();
  PovTransform matrix();
  void finish_object(PovObject* object, const Modifiers& modifiers);

  // Lights and camera, in lights.cpp. Each block is read from its opening brace.
  PovLight light_block();
  void light_item(PovLight* light);
  PovCamera camera_block();
  struct CameraAim {
    std::optional<double> angle;  // horizontal field of view, degrees
    std::optional<Vec3> look_at;
    PovTransform moved;
  };
  void camera_item(PovCamera* camera, CameraAim* aim);

  const ImportOptions& options_;
  ImportReport* report_;
  PovCutCache* cuts_;
  PovInterpreter in_;
  std::vector<Placed> placed_;
  std::optional<PovCamera> camera_;
  PovTexture default_texture_;
  // The object of which rays were asked last.
  struct Asked {
    std::shared_ptr<const PovObject> object;
    PovSolid solid;  // settled
    std::shared_ptr<const BoxTree> facets;
  };
  void prepare_rays(const std::shared_ptr<const PovObject>& object);  // in measures.cpp
  Asked asked_;
  bool radiosity_ = false;
  std::vector<PovProblem> sky_;  // what lights the scene with radiosity only
};

}  // namespace strad
