// A frame as layers, and its files.
#pragma once

#include <string>
#include <vector>

#include "frame/geometry_layers.h"
#include "frame/raster.h"
#include "image/encoding.h"
#include "image/layers.h"
#include "image/picture_facts.h"

namespace strad {

// The layers `kinds`, light first and mattes last. Light is scaled by 2^exposure, but albedo is not. The
// combined layer has no name. REQUIRES: what Raster::render requires.
LayeredImage render_layers(Raster* raster, const Scene& scene, const Slab& slab, const Camera& camera,
                           double time, const RasterOptions& options, double exposure,
                           const std::vector<LayerKind>& kinds);

// "room.direct.0001.png" for "room.0001.png": the word goes before the number at the end of the name, else
// before the extension.
std::string layer_path(const std::string& path, const std::string& word);

// Throws BadInput unless `path`, as typed for --output, names files that can hold the layers.
void require_layer_files(const std::string& path, const std::vector<LayerKind>& kinds);

// The files of a frame in layers: `path` if that names an EXR file or there is but one layer, else one file
// for each layer, at layer_path().
std::vector<std::string> layer_files(const std::string& path, const std::vector<LayerKind>& kinds);

// Writes the files of layer_files(). Normals are brought from -1..1 to 0..1, in proportion, unless it is EXR.
// REQUIRES: is_picture() of all of `kinds`, the layers of `image`, unless it is EXR.
void save_layered_frame(const std::string& path, const LayeredImage& image,
                        const std::vector<LayerKind>& kinds, const Encoding& encoding,
                        const PictureFacts& facts);

}  // namespace strad
