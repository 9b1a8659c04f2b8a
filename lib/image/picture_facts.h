// What a picture file tells of its picture besides the pixels.
#pragma once

#include <array>
#include <optional>
#include <string>

namespace strad {

// Rows of a matrix that row vectors are multiplied with from the left, (x y z 1) M, as in OpenEXR.
using Matrix44 = std::array<double, 16>;

struct PictureFacts {
  std::string software;    // name and version
  std::string provenance;  // a line for each tool that the picture went through
  std::string stream;      // a fingerprint of the scene and of how it was solved
  std::optional<int> frame;
  double time = 0;                            // s
  std::optional<double> rate;                 // frames per second
  double exposure = 0;                        // stops by which all light was scaled
  double shutter = 0;                         // s
  std::optional<double> screen_width;         // of what the camera sees 1 m ahead, m
  std::optional<Matrix44> camera_from_world;  // x right, y up, looking along -z; m
  std::optional<Matrix44> ndc_from_world;  // x -1 to 1 to the right, y -1 to 1 upwards, after division by w
};

}  // namespace strad
