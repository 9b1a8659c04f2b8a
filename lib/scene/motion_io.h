// The motion chunk: interval, bodies, spots, glows and cameras to bytes and back.
#pragma once

#include "scene/scene.h"
#include "stream/bytes.h"

namespace strad {

void put_motion(Bytes* to, const Scene& scene);
void get_motion(ByteReader* from, Scene* scene);

// The same bytes for two motions of one scene only if its light is the same: all of the motion but cameras
// and frame rate, with the body of each object.
Bytes motion_of_light(const Scene& scene);

}  // namespace strad
