#include "frame/layered_frame.h"

#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "image/files.h"

namespace strad {
namespace {

Image image_of(const LayeredImage& layered, const Layer& layer) {
  Image image(layered.width, layered.height);
  for (size_t i = 0; i < image.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) image.pixels[i][c] = layer.samples[3 * i + static_cast<size_t>(c)];
  return image;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool separates(char c) { return c == '.' || c == '_' || c == '-'; }

}  // namespace

LayeredImage render_layers(Raster* raster, const Scene& scene, const Slab& slab, const Camera& camera,
                           double time, const RasterOptions& options, double exposure,
                           const std::vector<LayerKind>& kinds) {
  LayeredImage image{options.width, options.height, {}, {}};
  const auto is_light = [](LayerKind kind) { return !is_geometry(kind); };
  if (std::any_of(kinds.begin(), kinds.end(), is_light)) {
    LightLayers light;
    Image combined = raster->render(slab, camera, time, options, &light);
    for (Image* one : {&combined, &light.direct, &light.indirect, &light.emission, &light.specular})
      expose(one, exposure);
    for (const LayerKind kind : kinds) {
      if (kind == LayerKind::kCombined) image.layers.push_back(layer_of(combined, ""));
      if (kind == LayerKind::kDirect) image.layers.push_back(layer_of(light.direct, "direct"));
      if (kind == LayerKind::kIndirect) image.layers.push_back(layer_of(light.indirect, "indirect"));
      if (kind == LayerKind::kEmission) image.layers.push_back(layer_of(light.emission, "emission"));
      if (kind == LayerKind::kSpecular) image.layers.push_back(layer_of(light.specular, "specular"));
    }
  }
  if (std::any_of(kinds.begin(), kinds.end(), is_geometry))
    add_geometry_layers(scene, raster->surfaces(), camera, time,
                        {options.width, options.height, options.samples}, kinds, &image);
  return image;
}

std::string layer_path(const std::string& path, const std::string& word) {
  const std::filesystem::path whole(path);
  std::string stem = whole.stem().string();
  size_t number = stem.size();
  while (number > 0 && is_digit(stem[number - 1])) --number;
  const bool numbered = number < stem.size() && (number == 0 || separates(stem[number - 1]));
  if (!numbered) {
    stem += "." + word;
  } else if (number == 0) {
    stem = word + "." + stem;
  } else {
    stem.insert(number - 1, "." + word);
  }
  return (whole.parent_path() / (stem + whole.extension().string())).string();
}

namespace {

// Of one layer of several, or of the only one.
std::string layer_file(const std::string& path, const std::vector<LayerKind>& kinds,
                       const std::string& word) {
  return kinds.size() > 1 ? layer_path(path, word) : path;
}

}  // namespace

void require_layer_files(const std::string& path, const std::vector<LayerKind>& kinds) {
  if (path.empty() || path == "-")
    throw BadInput("--layers: expected -o PATTERN, such as -o 'frame.%04d.exr'");
  for (const LayerKind kind : kinds)
    if (!is_picture(kind) && format_of(path) != "exr")
      throw BadInput(std::string("--layers: found ") + word_of(kind) + ", expected EXR files for it");
}

std::vector<std::string> layer_files(const std::string& path, const std::vector<LayerKind>& kinds) {
  if (format_of(path) == "exr") return {path};
  std::vector<std::string> files;
  for (const LayerKind kind : kinds) files.push_back(layer_file(path, kinds, word_of(kind)));
  return files;
}

void save_layered_frame(const std::string& path, const LayeredImage& image,
                        const std::vector<LayerKind>& kinds, const Encoding& encoding,
                        const PictureFacts& facts) {
  if (format_of(path) == "exr") return save_layers(path, image, encoding.depth, facts);
  for (const Layer& layer : image.layers) {
    const std::string word = layer.name.empty() ? word_of(LayerKind::kCombined) : layer.name;
    Encoding known = encoding;
    Image picture = image_of(image, layer);
    if (word == "normal") {
      for (Rgb& pixel : picture.pixels) pixel = 0.5f * (pixel + Rgb{1, 1, 1});
      known.tone = ToneCurve::kLinear;
      known.white = 1;
    }
    if (word == "albedo") known.tone = ToneCurve::kSrgb, known.white = 1;
    save_image(layer_file(path, kinds, word), picture, known, facts);
  }
}

}  // namespace strad
