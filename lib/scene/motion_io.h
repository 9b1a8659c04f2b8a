// The motion chunk: interval, bodies, spots, glows and cameras to bytes and back.
#pragma once

#include "scene/scene.h"
#include "stream/bytes.h"

namespace strad {

void put_motion(Bytes* to, const Scene& scene);
void get_motion(ByteReader* from, Scene* scene);

}  // namespace strad
