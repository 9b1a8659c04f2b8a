#include "frame/frame_facts.h"

#include <cstdio>
#include <fstream>

#include "base/error.h"
#include "base/rng.h"
#include "frame/projection.h"
#include "image/files.h"
#include "scene/scene_io.h"

namespace strad {

std::string fingerprint_of(const Scene& scene) {
  uint64_t all = 0;
  for (const Chunk& chunk : encode_scene(scene)) all = hash_of(all, checksum(chunk.content));
  char text[20];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(all));
  return text;
}

PictureFacts facts_of(const FrameRequest& request, const Scene& scene, const std::string& stream,
                      const Camera& camera, FrameTime frame, double exposure) {
  PictureFacts facts;
  facts.software = request.software;
  for (const std::string& line : scene.provenance) facts.provenance += line + "\n";
  facts.provenance += request.provenance;
  facts.stream = stream;
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

bool shows(const std::string& path, const PictureFacts& facts) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return false;
  // Texts stand at the head of EXR and PNG files as they are.
  std::string head(facts.provenance.size() + (1 << 16), '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<size_t>(file.gcount()));
  if (head.find(facts.provenance) == head.npos || head.find(facts.stream) == head.npos) return false;
  try {
    load_image(path);
  } catch (const BadInput&) {
    return false;
  }
  return true;
}

}  // namespace strad
