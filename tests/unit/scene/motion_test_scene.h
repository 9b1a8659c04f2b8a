// A scene of four objects and two materials for tests of the motion language.
#pragma once

#include "scene/scene.h"

namespace strad {

inline Scene motion_test_scene() {
  Scene scene;
  scene.objects = {{"floor", 0}, {"crane_mast", 0}, {"crane_arm", 0}, {"hook", 0}};
  scene.materials.resize(2);
  scene.materials[0].name = "plaster";
  scene.materials[1].name = "lamp glass";
  scene.materials[1].emission = {1, 1, 1};
  return scene;
}

}  // namespace strad
