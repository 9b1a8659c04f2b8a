#include "frame/frame_facts.h"

#include "frame/projection.h"

namespace strad {

PictureFacts facts_of(const FrameRequest& request, const Scene& scene, const Camera& camera, FrameTime frame,
                      double exposure) {
  PictureFacts facts;
  facts.software = request.software;
  for (const std::string& line : scene.provenance) facts.provenance += line + "\n";
  facts.provenance += request.provenance;
  facts.frame = frame.number;
  facts.time = frame.time;
  facts.rate = scene.rate;
  facts.exposure = exposure;
  facts.shutter = request.shutter / scene.rate;
  const Projection projection(camera_at(camera, frame.time), request.raster.width, request.raster.height);
  facts.screen_width = projection.screen_width();
  facts.camera_from_world = projection.camera_from_world();
  facts.ndc_from_world = projection.ndc_from_world();
  return facts;
}

}  // namespace strad
