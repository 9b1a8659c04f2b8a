#include "frame/show.h"

#include "frame/show_elements.h"
#include "frame/show_error.h"
#include "frame/show_openness.h"

namespace strad {
namespace {

constexpr double kUsualReach = 0.1;  // of openness, over the scene's diagonal

}  // namespace

Show::Show(const Scene& scene) : scene_(scene), tracer_(scene), surfaces_(scene, tracer_) {}

Image Show::render(const Slab* slab, const Camera& camera, double time, const ShowOptions& options) const {
  const ShowView view{scene_,
                      tracer_,
                      surfaces_,
                      instant_at(scene_, time),
                      CameraRays(camera_at(camera, time), options.width, options.height),
                      options.width,
                      options.height};
  if (options.what == ShowWhat::kElements) return elements_picture(view, slab->mesh);
  if (options.what == ShowWhat::kError) {
    Image values = error_values(view, *slab, time);
    expose(&values, options.exposure);
    return error_colours(values);
  }
  const double within = options.within > 0 ? options.within : kUsualReach * tracer_.scene_box().diagonal();
  Image picture = openness_picture(view, within, options.samples);
  expose(&picture, options.exposure);
  return picture;
}

}  // namespace strad
