#include "export/pov/pov.h"

#include <algorithm>
#include <map>

#include "base/error.h"
#include "export/mesh.h"
#include "export/pov/geometry.h"
#include "export/pov/lights.h"
#include "export/pov/names.h"
#include "export/pov/text.h"

namespace strad {
namespace {

constexpr int kMaxLampSamples = 256;
constexpr const char* kExposureGuard = "#ifndef (strad_exposure) #declare strad_exposure = 1; #end\n";

template <class Range>
std::vector<std::string> identifiers_of(const Range& named) {
  std::vector<std::string> names;
  for (const auto& thing : named) names.push_back(thing.name);
  return pov_identifiers(names);
}

void write_camera(const CameraState& camera, PovText* out) {
  const Vec3 direction = normalized(camera.to - camera.from);
  const Vec3 right = normalized(cross(direction, camera.up));
  const double height = 2 * std::tan(camera.fov / 2);
  *out << "#declare strad_camera = camera {\n  perspective location ";
  out->exact(camera.from) << " direction ";
  out->exact(direction) << "\n  right image_width/image_height*";
  out->exact(height * right) << "\n  up ";
  out->exact(height * cross(right, direction)) << "\n}\n";
}

}  // namespace

struct PovExport::State {
  const Scene& scene;
  const Solution& solution;
  std::vector<FrameTime> frames;
  PovOptions options;
  PovNames names;
  PovShading shading;
  PovIdentifiers identifiers;
  std::vector<std::string> spots;                      // identifiers
  std::map<uint32_t, std::vector<ExportBody>> meshes;  // of the slabs that frames fall into
  std::vector<PovLamp> lamps;

  State(const Scene& s, const Solution& light, const std::vector<FrameTime>& f, const PovOptions& o)
      : scene(s),
        solution(light),
        frames(f),
        options(o),
        names(o.pattern, f.size() > 1),
        shading(s, o.light == PovLighting::kBaked),
        spots(identifiers_of(s.spots)) {
    identifiers = {identifiers_of(s.bodies), identifiers_of(s.materials), {}};
    for (size_t m = 0; m < s.materials.size(); ++m) {
      identifiers.image_files.push_back(shading.image_of(m) ? without_folder(names.texture(m)) : "");
    }
    const ExportLight exported_light = baked() ? ExportLight::kAll : ExportLight::kIndirect;
    for (const FrameTime& frame : frames) {
      const uint32_t slab = slab_at(solution, frame.time);
      if (!meshes.contains(slab)) meshes[slab] = export_mesh(scene, solution.slabs[slab], exported_light);
    }
    if (options.light == PovLighting::kLights) lamps = pov_lamps(scene, options.lamp_samples);
  }

  bool baked() const { return options.light == PovLighting::kBaked; }

  void write_radiance(const ExportBody& body, const VertexLight& light, const std::vector<float>& glow,
                      PovText* out) const {
    *out << "#declare strad_radiance_" << identifiers.bodies[body.body] << " = array[" << body.corners.size()
         << "] {\n";
    size_t i = 0;
    for (const ExportCorner& corner : body.corners) {
      Rgb irradiance = corner_irradiance(corner, light.indirect);
      if (baked()) irradiance += corner_irradiance(corner, light.direct);
      *out << shading.value(corner, irradiance, glow[corner.material]) << (++i % 4 == 0 ? ",\n" : ",");
    }
    *out << "}\n";
  }

  void write_lights(const std::vector<Pose>& world_from_body, double time, const std::vector<float>& glow,
                    PovText* out) const {
    std::vector<std::string> lit;
    for (size_t i = 0; i < scene.spots.size() && !baked(); ++i) {
      const SpotState state = spot_at(scene, scene.spots[i], world_from_body, time);
      if (is_black(state.intensity)) continue;
      lit.push_back("strad_spot_" + spots[i]);
      write_spot(scene.spots[i], state, lit.back(), out);
    }
    for (size_t first = 0, last = 0; first < lamps.size(); first = last) {
      const uint32_t material = lamps[first].material;
      while (last < lamps.size() && lamps[last].material == material) ++last;
      const Rgb radiance = glow[material] * scene.materials[material].emission;
      if (is_black(radiance)) continue;
      lit.push_back("strad_lamp_" + identifiers.materials[material]);
      write_lamps(&lamps[first], &lamps[0] + last, radiance, world_from_body, lit.back(), out);
    }
    *out << "#macro strad_lights()\n";
    for (const std::string& name : lit) *out << "  object { " << name << " }\n";
    *out << "#end\n";
  }

  std::string scene_text() const;
  std::string ini_text() const;
};

std::string PovExport::State::scene_text() const {
  PovText out;
  out << "// Frames of an animation lit by strad; the names used here: strad-pov(5).\n#version 3.7;\n"
      << "#declare strad_exposure = " << std::exp2(options.exposure) << ";\n"
      << "global_settings { assumed_gamma 1 adc_bailout 1e-5 }\n"
      << "#declare strad_frame = max(" << frames.front().number << ", min(" << frames.back().number
      << ", frame_number));\n#include " << names.frame_expression("strad_frame")
      << "\n#include strad_geometry\n\n"
      << "camera { strad_camera }\nstrad_lights()\n";
  std::vector<bool> has_polygons(scene.bodies.size(), false);
  for (const Polygon& polygon : scene.polygons) has_polygons[body_of(scene, polygon)] = true;
  for (size_t b = 0; b < scene.bodies.size(); ++b) {
    if (!has_polygons[b]) continue;
    out << "object { strad_body_" << identifiers.bodies[b];
    if (b > 0) out << " transform { strad_pose_" << identifiers.bodies[b] << " }";
    out << " }\n";
  }
  return out.take();
}

std::string PovExport::State::ini_text() const {
  const int step = frames.size() > 1 ? frames[1].number - frames[0].number : 1;
  PovText out;
  out << "; povray " << names.ini()
      << " renders these frames; anything may be overridden behind it, as in +W320 +FE.\n"
      << "Input_File_Name=\"" << without_folder(names.scene()) << "\"\n";
  if (!names.folder().empty()) out << "Library_Path=\"" << names.folder() << "\"\n";
  out << "Initial_Frame=" << frames.front().number << "\nFinal_Frame=" << frames.back().number
      << "\nFrame_Step=" << step << "\nInitial_Clock=" << frames.front().time
      << "\nFinal_Clock=" << frames.back().time << "\nWidth=" << options.width
      << "\nHeight=" << options.height
      << "\nOutput_File_Type=N\nAntialias=On\nSampling_Method=2\nAntialias_Threshold=0.1\nAntialias_Depth="
         "4\nJitter=Off\nDisplay=Off\n";
  return out.take();
}

PovExport::PovExport(const Scene& scene, const Solution& solution, const std::vector<FrameTime>& frames,
                     const PovOptions& options) {
  if (frames.empty()) throw BadInput("no frames to export, expected at least one");
  if (!(options.lamp_samples >= 1 && options.lamp_samples <= kMaxLampSamples)) {
    throw BadInput(std::to_string(options.lamp_samples) + " lights along a lamp, expected 1 to 256");
  }
  state_ = std::make_unique<const State>(scene, solution, frames, options);
}

PovExport::~PovExport() = default;

std::vector<ExportFile> PovExport::common_files() const {
  const State& s = *state_;
  std::vector<ExportFile> files{{s.names.ini(), s.ini_text()}, {s.names.scene(), s.scene_text()}};
  for (size_t m = 0; m < s.scene.materials.size(); ++m) {
    if (s.shading.image_of(m))
      files.push_back({s.names.texture(m), pov_image(s.scene, s.scene.materials[m])});
  }
  for (const auto& [slab, mesh] : s.meshes) {
    PovText out;
    out << "// Surfaces at rest, lit by the arrays of a frame's include; the names: strad-pov(5).\n"
        << kExposureGuard;
    write_pigments(s.scene, s.shading, s.identifiers, &out);
    for (const ExportBody& body : mesh) write_body(s.shading, body, s.identifiers, &out);
    files.push_back({s.names.geometry(slab), out.take()});
  }
  return files;
}

ExportFile PovExport::frame_file(size_t i) const {
  const State& s = *state_;
  const FrameTime& frame = s.frames[i];
  const uint32_t slab = slab_at(s.solution, frame.time);
  const VertexLight light = light_at(s.solution.slabs[slab], frame.time);
  const std::vector<float> glow = glow_at(s.scene, frame.time);
  const std::vector<Pose> world_from_body = poses_at(s.scene, frame.time);
  const std::vector<ExportBody>& mesh = s.meshes.at(slab);
  size_t corners = 0;
  for (const ExportBody& body : mesh) corners += body.corners.size();

  PovText out(4096 + corners * 30);  // "<12345e-4,12345e-4,12345e-4>,"
  out << "// Frame " << frame.number << ": poses, light and camera; the names: strad-pov(5).\n"
      << kExposureGuard << "#declare strad_time = " << frame.time << ";\n#declare strad_geometry = \""
      << without_folder(s.names.geometry(slab)) << "\";\n";
  write_camera(camera_at(s.options.camera, frame.time), &out);
  for (size_t b = 1; b < s.scene.bodies.size(); ++b) {
    out << "#declare strad_pose_" << s.identifiers.bodies[b] << " = transform { " << world_from_body[b]
        << " }\n";
  }
  s.write_lights(world_from_body, frame.time, glow, &out);
  for (const ExportBody& body : mesh) s.write_radiance(body, light, glow, &out);
  return {s.names.frame(frame.number), out.take()};
}

}  // namespace strad
