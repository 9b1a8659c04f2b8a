// POV-Ray's light sources and camera.
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "import/pov/scene.h"
#include "import/pov/shapes.h"

namespace strad {

PovLight PovSceneReader::light_block() {
  PovLight light;
  light.place = place();
  expect("{");
  if (std::string name; auto known = named<PovLight>(&name)) {
    light = *known;
    light.name = name;
  } else {
    light.location = vector();
    skip_comma();
    light.colour = colour();
  }
  while (!take_if("}")) light_item(&light);
  return light;
}

void PovSceneReader::light_item(PovLight* light) {
  const PovPlace at = place();
  PovTransform moved;
  skip_comma();
  if (transformation(&moved)) {
    PovObject carrier;
    carrier.lights = {*light};
    move_object(&carrier, moved);
    *light = carrier.lights[0];
  } else if (take_if("spotlight")) {
    light->spotlight = true;
  } else if (take_if("point_at")) {
    light->point_at = vector();
  } else if (take_if("radius")) {
    light->radius = number();
  } else if (take_if("falloff")) {
    light->falloff = number();
  } else if (take_if("tightness")) {
    light->tightness = number();
  } else if (take_if("fade_distance")) {
    light->fade_distance = number();
  } else if (take_if("fade_power")) {
    light->fade_power = number();
  } else if (take_if("area_light")) {
    light->area = true;
    light->axis1 = vector();
    skip_comma();
    light->axis2 = vector();
    skip_comma();
    light->size1 = integer();
    skip_comma();
    light->size2 = integer();
  } else if (take_if("adaptive") || take_if("area_illumination") || take_if("media_interaction") ||
             take_if("media_attenuation")) {
    if (expression_is_next()) number();
  } else if (take_if("jitter") || take_if("circular") || take_if("orient")) {
    return;
  } else if (next_is("photons")) {
    skip_item();
  } else if (take_if("looks_like")) {
    skip_block();
    report_->add("looks_like left out: spotlights are points, area lights show themselves", at.file, at.line);
  } else if (peek().kind == PovKind::kWord) {
    light->problems.push_back({"light_source " + std::string(peek().text), at});
    skip_item();
  } else {
    fail_expected("a light's property or }");
  }
}

// POV-Ray's order: what `angle` and `look_at` say counts at the end, wherever they stand.
PovCamera PovSceneReader::camera_block() {
  PovCamera camera;
  camera.place = place();
  std::optional<double> angle;
  std::optional<Vec3> look_at;
  PovTransform moved;
  expect("{");
  if (std::string name; auto known = named<PovCamera>(&name)) {
    camera = *known;
    camera.name = name;
  }
  while (!take_if("}")) {
    if (take_if("location")) {
      camera.location = vector();
    } else if (take_if("direction")) {
      camera.direction = vector();
    } else if (take_if("right")) {
      camera.right = vector();
    } else if (take_if("up")) {
      camera.up = vector();
    } else if (take_if("sky")) {
      camera.sky = vector();
    } else if (take_if("angle")) {
      angle = number();
      if (take_if(",")) number();
    } else if (take_if("look_at")) {
      look_at = vector();
    } else if (transformation(&moved) || take_if("perspective")) {
      continue;
    } else if (next_is("focal_point") || next_is("aperture") || next_is("blur_samples") ||
               next_is("confidence") || next_is("variance") || next_is("normal")) {
      skip_item();
    } else if (peek().kind == PovKind::kWord) {
      camera.problem = PovProblem{"camera " + std::string(peek().text), place()};
      skip_item();
    } else {
      fail_expected("a camera's property or }");
    }
  }
  if (angle) {
    if (camera.problem) angle = 90;  // of panoramas; refused when it is used
    if (!(*angle > 0 && *angle < 180))
      fail_at(camera.place.file, camera.place.line, "the angle of the camera is not within 0 to 180 degrees");
    camera.direction = length(camera.right) / 2 / std::tan(*angle * kPi / 360) * normalized(camera.direction);
  }
  if (look_at) {
    const bool left_handed = dot(cross(camera.direction, camera.up), camera.right) < 0;
    const Vec3 direction = normalized(*look_at - camera.location);
    Vec3 across = cross(direction, camera.sky);
    if (!(length(across) > 1e-9)) across = (left_handed ? -1 : 1) * camera.right;  // straight up or down
    const Vec3 right = normalized(across);
    camera.up = length(camera.up) * cross(right, direction);
    camera.right = (left_handed ? -1 : 1) * length(camera.right) * right;
    camera.direction = length(camera.direction) * direction;
  }
  camera.location = moved.point(camera.location);
  camera.direction = moved.direction(camera.direction);
  camera.right = moved.direction(camera.right);
  camera.up = moved.direction(camera.up);
  return camera;
}

}  // namespace strad
