#include "frame/raster.h"

#include <algorithm>
#include <optional>

#include "base/error.h"
#include "base/parallel.h"
#include "frame/tile.h"

namespace strad {
namespace {

// Pixels: the first that shares out a frame well among the threads. Large ones spend less on their margins.
constexpr uint32_t kTileSides[] = {96, 64, 48};
constexpr size_t kTilesOfThread = 4;
constexpr int kShutterInstants =
    64;  // poses over an open shutter: more than samples of a pixel, so that no steps show

// The instants of an exposure: one, or the middles of equal parts.
std::vector<double> exposure_times(double time, double shutter) {
  if (!(shutter > 0)) return {time};
  std::vector<double> times;
  for (int i = 0; i < kShutterInstants; ++i) times.push_back(time + shutter * (i + 0.5) / kShutterInstants);
  return times;
}

std::vector<TileRect> tiles_of(uint32_t width, uint32_t height) {
  std::vector<TileRect> tiles;
  for (const uint32_t side : kTileSides) {
    tiles.clear();
    for (uint32_t y = 0; y < height; y += side)
      for (uint32_t x = 0; x < width; x += side)
        tiles.push_back({x, y, std::min(x + side, width), std::min(y + side, height)});
    if (tiles.size() >= kTilesOfThread * static_cast<size_t>(thread_count())) break;
  }
  return tiles;
}

void check(const RasterOptions& options) {
  if (options.samples < 1)
    throw BadInput("samples: found " + std::to_string(options.samples) + ", expected at least 1");
  if (options.lamp_samples < 1)
    throw BadInput("lamp samples: found " + std::to_string(options.lamp_samples) + ", expected at least 1");
  if (!(options.shutter >= 0)) throw BadInput("shutter: expected 0 or more");
}

}  // namespace

Raster::Raster(const Scene& scene)
    : scene_(scene), tracer_(scene), surfaces_(scene, tracer_), groups_(emitter_groups(scene)) {}
Raster::~Raster() = default;

void Raster::prepare_for(const Slab& slab) {
  if (reconstructed_ == &slab && reconstructed_begin_ == slab_begin(slab)) return;
  reconstruction_ = std::make_unique<Reconstruction>(slab.mesh);
  joints_ = std::make_unique<SmoothJoints>(scene_, slab.mesh, *reconstruction_);
  reconstructed_ = &slab;
  reconstructed_begin_ = slab_begin(slab);
}

Image Raster::render(const Slab& slab, const Camera& camera, double time, const RasterOptions& options,
                     LightLayers* layers) {
  check(options);
  const bool trace_direct = options.direct == DirectFrom::kPixel;
  const double end =
      std::min(time + options.shutter, slab_end(slab));  // the slab has no light beyond its end
  prepare_for(slab);
  const FrameLight light(slab, *reconstruction_, *joints_, time, end, {!trace_direct, options.flat});
  std::optional<FrameLight> indirect;
  if (layers && !trace_direct)
    indirect.emplace(slab, *reconstruction_, *joints_, time, end, FrameLightOptions{false, options.flat});
  FrameView view{scene_,
                 surfaces_,
                 light,
                 {},
                 {},
                 trace_direct ? groups_.size() : 0,
                 trace_direct,
                 indirect ? &*indirect : nullptr,
                 static_cast<uint32_t>(options.lamp_samples)};
  for (const double instant : exposure_times(time, options.shutter)) {
    view.instants.emplace_back(scene_, tracer_, groups_, instant);
    view.cameras.emplace_back(camera_at(camera, instant), options.width, options.height);
  }
  Image image(options.width, options.height);
  if (layers) *layers = {image, image, image, image};
  const std::vector<TileRect> tiles = tiles_of(options.width, options.height);
  parallel_for(tiles.size(), 1, [&](size_t first, size_t last) {
    for (size_t t = first; t < last; ++t) render_tile(view, options.samples, tiles[t], &image, layers);
  });
  return image;
}

std::vector<Rgb> Raster::reflected_light(const Slab& slab, const Camera& camera, double time, uint32_t width,
                                         uint32_t height) {
  prepare_for(slab);
  const FrameLight light(slab, *reconstruction_, *joints_, time, time, {true, false});
  const CameraRays rays(camera_at(camera, time), width, height);
  const Instant instant = instant_at(scene_, time);
  std::vector<Rgb> seen;
  for (uint32_t y = 0; y < height; ++y) {
    for (uint32_t x = 0; x < width; ++x) {
      const Sight sight = surfaces_.look(instant, rays.from(), rays.direction(x + 0.5, y + 0.5));
      if (sight.point.polygon == kNone || !is_black(sight.emission)) continue;
      uint32_t leaf = kNone;
      const Rgb irradiance = light.irradiance(sight.point.polygon, sight.front, sight.at, &leaf);
      seen.push_back(static_cast<float>(1 / kPi) * sight.reflectance * irradiance);
    }
  }
  return seen;
}

}  // namespace strad
