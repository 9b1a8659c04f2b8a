#include "export/pov/geometry.h"

#include <algorithm>

#include "image/srgb.h"
#include "scene/glass.h"
#include "scene/texture.h"

namespace strad {
namespace {

// The smallest pigment of an emitting surface. POV-Ray multiplies the emission by it, so it must not be 0.
// The light that the surface then reflects is too little to show in 8 bits.
constexpr float kLeastPigment = 1e-4f;

Rgb at_least(Rgb colour, float least) {
  return {std::max(colour.r, least), std::max(colour.g, least), std::max(colour.b, least)};
}

// Appends the texture_list entries of corners [begin, end), which have one material and all an image or none.
void write_textures(const PovShading& shading, const ExportBody& body, size_t begin, size_t end,
                    const PovIdentifiers& names, PovText* out) {
  const ExportCorner& corner = body.corners[begin];
  std::string light = "strad_radiance_" + names.bodies[body.body] + "[strad_i]";
  *out << "    #for (strad_i, " << begin << ", " << end - 1 << ") texture { pigment { ";
  const Rgb passes = shading.passes(corner.material);
  const std::string mirror = shading.mirror(corner.material);
  if (shading.is_clear(corner.material) && !is_black(passes)) {
    *out << "rgb " << passes << " filter 1 } finish { strad_finish diffuse 0" << mirror << " } } #end\n";
    return;
  }
  // What is opaque of glass shows all of the light: POV-Ray multiplies it by how opaque the pigment is.
  const float transmit = std::min(mean_channel(passes), 0.999f);
  if (transmit > 0) light += "/" + std::to_string(1 - transmit);
  const std::string through = transmit > 0 ? " transmit " + std::to_string(transmit) : "";
  if (shading.has_pigment(corner)) {
    *out << (shading.has_image(corner) ? "strad_image_" : "strad_pigment_")
         << names.materials[corner.material] << through
         << " } finish { strad_finish emission rgb strad_exposure*" << light << mirror;
  } else {
    *out << "rgb " << light << through << " } finish { strad_finish emission strad_exposure" << mirror;
  }
  *out << " } } #end\n";
}

void write_texture_list(const PovShading& shading, const ExportBody& body, const PovIdentifiers& names,
                        PovText* out) {
  const std::vector<ExportCorner>& corners = body.corners;
  const auto alike = [&](const ExportCorner& a, const ExportCorner& b) {
    return a.material == b.material && a.textured == b.textured;
  };
  *out << "  texture_list { " << corners.size() << ",\n";
  for (size_t begin = 0, end = 0; begin < corners.size(); begin = end) {
    while (end < corners.size() && alike(corners[begin], corners[end])) ++end;
    write_textures(shading, body, begin, end, names, out);
  }
  *out << "  }\n";
}

void write_uvs(const std::vector<ExportCorner>& corners, PovText* out) {
  *out << "  uv_vectors { " << corners.size() << ",\n";
  for (const ExportCorner& corner : corners) {
    *out << "<" << static_cast<float>(corner.uv.x) << "," << static_cast<float>(corner.uv.y) << ">\n";
  }
  *out << "  }\n";
}

}  // namespace

PovShading::PovShading(const Scene& scene, bool baked)
    : scene_(scene), baked_(baked), textured_reflectance_(textured_reflectances(scene)) {
  for (size_t m = 0; m < scene.materials.size(); ++m) {
    const Material& material = scene.materials[m];
    const bool emits = !is_black(material.emission);
    pigment_.push_back(emits ? at_least(textured_reflectance_[m], kLeastPigment) : material.reflectance);
    bends_.push_back(material.finish.fresnel && is_black(material.finish.transmission));
  }
  const std::vector<GlassKind> kinds = glass_kinds(scene);
  for (size_t p = 0; p < kinds.size(); ++p)
    if (kinds[p] == GlassKind::kSolid || kinds[p] == GlassKind::kInverted)
      bends_[scene.polygons[p].material] = true;
}

std::string PovShading::mirror(size_t material) const {
  const Finish& finish = scene_.materials[material].finish;
  if (is_black(finish.specular)) return "";
  PovText text;
  if (finish.fresnel)
    text << " reflection { rgb 0, rgb " << finish.specular << " fresnel on }";
  else
    text << " reflection { rgb " << finish.specular << " }";
  return text.take();
}

bool PovShading::is_clear(size_t material) const {
  const Material& m = scene_.materials[material];
  return is_black(m.reflectance) && is_black(m.emission);
}

float PovShading::ior_of(const ExportBody& body, bool glass) const {
  for (const ExportCorner& corner : body.corners)
    if (bends_[corner.material] && is_black(passes(corner.material)) != glass)
      return scene_.materials[corner.material].finish.ior;
  return 1;
}

bool PovShading::image_of(size_t material) const {
  return scene_.materials[material].texture != kNone && is_black(scene_.materials[material].emission);
}

Rgb PovShading::value(const ExportCorner& corner, Rgb irradiance, float glow) const {
  const Material& material = scene_.materials[corner.material];
  const Rgb radiosity = (1 / static_cast<float>(kPi)) * irradiance;
  if (has_pigment(corner) && is_black(material.emission)) return radiosity;
  const Rgb emitted = corner.emits ? glow * material.emission : Rgb{};
  const Rgb reflectance = corner.textured ? textured_reflectance_[corner.material] : material.reflectance;
  const Rgb radiance = emitted + reflectance * radiosity;
  if (!has_pigment(corner)) return radiance;
  const Rgb p = pigment_[corner.material];
  return {radiance.r / p.r, radiance.g / p.g, radiance.b / p.b};
}

void write_pigments(const Scene& scene, const PovShading& shading, const PovIdentifiers& names,
                    PovText* out) {
  *out << "#declare strad_finish = finish { ambient 0 diffuse " << (shading.baked() ? 0 : 1) << " }\n"
       << "#declare strad_dark = texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }\n";
  for (size_t m = 0; m < scene.materials.size(); ++m) {
    if (!shading.baked()) {
      *out << "#declare strad_pigment_" << names.materials[m] << " = pigment { rgb " << shading.pigment(m)
           << " }\n";
    }
    if (shading.image_of(m)) {
      *out << "#declare strad_image_" << names.materials[m] << " = pigment { uv_mapping image_map { ppm \""
           << names.image_files[m] << "\" gamma 1 interpolate 2 } }\n";
    }
  }
}

namespace {

// The triangles of a body that are glass, or all others, as a mesh.
void write_mesh(const PovShading& shading, const ExportBody& body, bool glass, const PovIdentifiers& names,
                PovText* out) {
  const std::vector<ExportCorner>& corners = body.corners;
  *out << "mesh2 {\n  vertex_vectors { " << corners.size() << ",\n";
  for (const ExportCorner& corner : corners) *out << corner.position << "\n";
  *out << "  }\n";
  const auto has_image = [&](const ExportCorner& corner) { return shading.has_image(corner); };
  if (std::any_of(corners.begin(), corners.end(), has_image)) write_uvs(corners, out);
  write_texture_list(shading, body, names, out);
  const auto wanted = [&](const auto& triangle) {
    return is_black(shading.passes(corners[triangle[0]].material)) != glass;
  };
  *out << "  face_indices { "
       << static_cast<size_t>(std::count_if(body.triangles.begin(), body.triangles.end(), wanted)) << ",\n";
  for (const auto& triangle : body.triangles) {
    if (!wanted(triangle)) continue;
    const auto& [a, b, c] = triangle;
    // POV-Ray's space is left-handed: its front sides are clockwise, ours counter-clockwise.
    *out << "<" << a << "," << c << "," << b << ">," << a << "," << c << "," << b << "\n";
  }
  *out << "  }\n";
  // Glass is seen from inside too.
  if (!glass) *out << "  texture { strad_dark } interior_texture { strad_dark }\n";
  const float ior = shading.ior_of(body, glass);
  if (ior != 1) *out << "  interior { ior " << ior << " }\n";
  *out << "}\n";
}

}  // namespace

void write_body(const PovShading& shading, const ExportBody& body, const PovIdentifiers& names,
                PovText* out) {
  const auto is_glass = [&](const auto& triangle) {
    return !is_black(shading.passes(body.corners[triangle[0]].material));
  };
  const bool any = std::any_of(body.triangles.begin(), body.triangles.end(), is_glass);
  const bool all = any && std::all_of(body.triangles.begin(), body.triangles.end(), is_glass);
  *out << "#declare strad_body_" << names.bodies[body.body] << " = ";
  if (!any || all) return write_mesh(shading, body, all, names, out);
  *out << "union {\n";
  for (const bool glass : {false, true}) write_mesh(shading, body, glass, names, out);
  *out << "}\n";
}

std::string pov_image(const Scene& scene, const Material& material) {
  const Texture& texture = scene.textures[material.texture];
  std::string ppm =
      "P6\n" + std::to_string(texture.width) + " " + std::to_string(texture.height) + "\n65535\n";
  for (size_t i = 0; i < texture.srgb.size(); ++i) {
    const float value = material.reflectance[static_cast<int>(i % 3)] * linear_from_byte(texture.srgb[i]);
    const auto word = static_cast<uint32_t>(65535 * std::clamp(value, 0.0f, 1.0f) + 0.5f);
    ppm += static_cast<char>(word >> 8);  // most significant byte first, as netpbm has it
    ppm += static_cast<char>(word & 255);
  }
  return ppm;
}

}  // namespace strad
