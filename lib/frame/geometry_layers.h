// Layers of a frame that camera rays find without any light: what is where, and how it moves in the picture.
#pragma once

#include <vector>

#include "frame/camera.h"
#include "frame/layer_list.h"
#include "frame/surfaces.h"
#include "image/layers.h"

namespace strad {

struct GeometryOptions {
  uint32_t width = 640, height = 480;  // pixels
  int samples = 16;                    // of albedo and mattes, per pixel in which edges show
};

// Appends those of `kinds` that are geometry, in their order, of the instant `time`:
//   albedo     reflectance, the mean over the pixel
//   normal     unit, world, of the side that is seen; with position, depth and motion at the pixel's middle
//   position   world, m
//   depth      Z: m along the axis of view; 1e10 where nothing is seen
//   motion     forward and backward: u and v by which what is seen moves to the next frame and to the one
//              before, in pixels to the right and upwards; 0 where nothing is seen and where it goes behind
//              the camera
//   object     CryptoObject00 to 02, and CryptoMaterial00 to 02 for material: a Cryptomatte
void add_geometry_layers(const Scene& scene, const Surfaces& surfaces, const Camera& camera, double time,
                         const GeometryOptions& options, const std::vector<LayerKind>& kinds,
                         LayeredImage* image);

}  // namespace strad
