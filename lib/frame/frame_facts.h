// What the files of a frame tell of it.
#pragma once

#include "frame/frame_request.h"
#include "image/picture_facts.h"

namespace strad {

PictureFacts facts_of(const FrameRequest& request, const Scene& scene, const Camera& camera, FrameTime frame,
                      double exposure);

}  // namespace strad
