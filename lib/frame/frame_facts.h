// What the files of a frame tell of it.
#pragma once

#include <string>

#include "frame/frame_request.h"
#include "image/picture_facts.h"

namespace strad {

// A hash of the scene as a stream holds it, with the lines that say how it was made and solved: 16
// hexadecimal digits.
std::string fingerprint_of(const Scene& scene);

// `stream`: its fingerprint.
PictureFacts facts_of(const FrameRequest& request, const Scene& scene, const std::string& stream,
                      const Camera& camera, FrameTime frame, double exposure);

// Is there a whole picture at `path` that tells the same provenance and stream? REQUIRES: a format with
// facts.
bool shows(const std::string& path, const PictureFacts& facts);

}  // namespace strad
