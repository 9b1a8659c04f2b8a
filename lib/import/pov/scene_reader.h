// Reads POV-Ray's textures, objects, lights and camera.
#pragma once

#include <string>
#include <vector>

#include "import/import.h"
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
  PovSceneReader(const ImportOptions& options, const PovRun& run, PovFiles* files, ImportReport* report)
      : options_(options), report_(report), in_(options, run, files, report, this) {}

  using Placed = PovPlaced;

  // Reads the file at `path`. Throws IoError or BadInput.
  void read(const std::string& path);

  std::vector<Placed>& placed() { return placed_; }
  const std::optional<PovCamera>& camera() const { return camera_; }

 private:
  std::any describe(std::string_view word) override;
  void name_declared(const std::string& name, std::any* value) override;
  void default_block() override;
  void statement();

  // Textures, in textures.cpp. Each function reads from the opening brace.
  PovTexture texture_block(const PovTexture& base);
  PovPigment pigment_block(const PovPigment& base);
  PovFinish finish_block(const PovFinish& base);
  PovTexture material_block(const PovTexture& base);
  std::shared_ptr<const PovImage> image_block();
  PovSurfacePointer surface_of(const PovTexture& texture);
  static PovSurfacePointer mean_of(const PovSurfacePointer& a, const PovSurfacePointer& b,
                                   const PovSurfacePointer& c);

  // Objects, in objects.cpp, primitives.cpp and meshes.cpp.
  struct Modifiers {
    PovTransform transform;
    std::optional<PovTexture> texture;
    bool no_shadow = false, no_image = false;
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
  PovInterpreter in_;
  std::vector<Placed> placed_;
  std::optional<PovCamera> camera_;
  PovTexture default_texture_;
};

}  // namespace strad
