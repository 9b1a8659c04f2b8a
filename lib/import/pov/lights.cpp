// POV-Ray's light sources and camera.
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "import/pov/scene_reader.h"
#include "import/pov/shapes.h"

namespace strad {
namespace {

// `angle`: the horizontal field of view, degrees.
void set_angle(PovCamera* camera, double angle) {
  if (!(angle > 0 && angle < 180))
    fail_at(camera->place.file, camera->place.line, "the angle of the camera is not within 0 to 180 degrees");
  camera->direction = length(camera->right) / 2 / std::tan(angle * kPi / 360) * normalized(camera->direction);
}

void turn_to(PovCamera* camera, Vec3 point) {
  const bool left_handed = dot(cross(camera->direction, camera->up), camera->right) < 0;
  const Vec3 direction = normalized(point - camera->location);
  Vec3 across = cross(direction, camera->sky);
  if (!(length(across) > 1e-9)) across = (left_handed ? -1 : 1) * camera->right;  // straight up or down
  const Vec3 right = normalized(across);
  camera->up = length(camera->up) * cross(right, direction);
  camera->right = (left_handed ? -1 : 1) * length(camera->right) * right;
  camera->direction = length(camera->direction) * direction;
}

}  // namespace

PovLight PovSceneReader::light_block() {
  PovLight light;
  light.place = in_.place();
  in_.expect("{");
  if (std::string name; auto known = in_.named<PovLight>(&name)) {
    light = *known;
    light.name = name;
  } else {
    light.location = in_.vector();
    in_.skip_comma();
    light.colour = in_.colour();
  }
  while (!in_.take_if("}")) light_item(&light);
  return light;
}

void PovSceneReader::light_item(PovLight* light) {
  const PovPlace at = in_.place();
  PovTransform moved;
  in_.skip_comma();
  if (transformation(&moved)) {
    PovObject carrier;
    carrier.lights = {*light};
    move_object(&carrier, moved);
    *light = carrier.lights[0];
  } else if (in_.take_if("spotlight")) {
    light->spotlight = true;
  } else if (in_.take_if("point_at")) {
    light->point_at = in_.vector();
  } else if (in_.take_if("radius")) {
    light->radius = in_.number();
  } else if (in_.take_if("falloff")) {
    light->falloff = std::abs(in_.number());  // POV-Ray takes its cosine
  } else if (in_.take_if("tightness")) {
    light->tightness = in_.number();
  } else if (in_.take_if("fade_distance")) {
    light->fade_distance = in_.number();
  } else if (in_.take_if("fade_power")) {
    light->fade_power = in_.number();
  } else if (in_.take_if("area_light")) {
    light->area = true;
    light->axis1 = in_.vector();
    in_.skip_comma();
    light->axis2 = in_.vector();
    in_.skip_comma();
    light->size1 = in_.integer();
    in_.skip_comma();
    light->size2 = in_.integer();
  } else if (in_.take_if("adaptive") || in_.take_if("area_illumination") ||
             in_.take_if("media_interaction") || in_.take_if("media_attenuation")) {
    if (in_.expression_is_next()) in_.number();
  } else if (in_.take_if("jitter") || in_.take_if("circular") || in_.take_if("orient")) {
    return;
  } else if (in_.next_is("photons")) {
    in_.skip_item();
  } else if (in_.take_if("looks_like")) {
    in_.skip_block();
    report_->add("looks_like left out: spotlights are points, area lights show themselves", at.file, at.line);
  } else if (in_.peek().kind == PovKind::kWord) {
    light->problems.push_back({"light_source " + std::string(in_.peek().text), at});
    in_.skip_item();
  } else {
    in_.fail_expected("a light's property or }");
  }
}

void PovSceneReader::camera_item(PovCamera* camera, CameraAim* aim) {
  if (in_.take_if("location")) {
    camera->location = in_.vector();
  } else if (in_.take_if("direction")) {
    camera->direction = in_.vector();
  } else if (in_.take_if("right")) {
    camera->right = in_.vector();
  } else if (in_.take_if("up")) {
    camera->up = in_.vector();
  } else if (in_.take_if("sky")) {
    camera->sky = in_.vector();
  } else if (in_.take_if("angle")) {
    aim->angle = in_.number();
    if (in_.take_if(",")) in_.number();
  } else if (in_.take_if("look_at")) {
    aim->look_at = in_.vector();
  } else if (transformation(&aim->moved) || in_.take_if("perspective")) {
    return;
  } else if (in_.next_is("focal_point") || in_.next_is("aperture") || in_.next_is("blur_samples") ||
             in_.next_is("confidence") || in_.next_is("variance") || in_.next_is("normal")) {
    in_.skip_item();
  } else if (in_.peek().kind == PovKind::kWord) {
    camera->problem = PovProblem{"camera " + std::string(in_.peek().text), in_.place()};
    in_.skip_item();
  } else {
    in_.fail_expected("a camera's property or }");
  }
}

// As in POV-Ray, `angle` and `look_at` are applied after all other items, wherever they stand.
PovCamera PovSceneReader::camera_block() {
  PovCamera camera;
  camera.place = in_.place();
  CameraAim aim;
  in_.expect("{");
  if (std::string name; auto known = in_.named<PovCamera>(&name)) {
    camera = *known;
    camera.name = name;
  }
  while (!in_.take_if("}")) camera_item(&camera, &aim);
  // The angle of a panorama may be 180 degrees or more. Such cameras are refused only if they are used.
  if (aim.angle) set_angle(&camera, camera.problem ? 90 : *aim.angle);
  if (aim.look_at) turn_to(&camera, *aim.look_at), camera.look_at = aim.look_at;
  camera.location = aim.moved.point(camera.location);
  camera.direction = aim.moved.direction(camera.direction);
  camera.right = aim.moved.direction(camera.right);
  camera.up = aim.moved.direction(camera.up);
  return camera;
}

}  // namespace strad
