#include "scene/finish_io.h"

#include "base/error.h"
#include "scene/rgb_io.h"

namespace strad {
namespace {

// Frozen numbers of flags.
constexpr uint32_t kFresnel = 1, kMetallic = 2;

}  // namespace

void put_finishes(Bytes* to, const std::vector<Material>& materials) {
  put_varint(to, materials.size());
  for (const Material& material : materials) {
    const Finish& finish = material.finish;
    put_rgb(to, finish.specular);
    put_f32(to, finish.roughness);
    put_rgb(to, finish.transmission);
    put_f32(to, finish.ior);
    put_varint(to, (finish.fresnel ? kFresnel : 0) | (finish.metallic ? kMetallic : 0));
  }
}

std::vector<Finish> get_finishes(ByteReader* from) {
  std::vector<Finish> finishes(from->count(33, "finishes"));
  for (Finish& finish : finishes) {
    finish.specular = get_rgb(from);
    finish.roughness = from->f32();
    finish.transmission = get_rgb(from);
    finish.ior = from->f32();
    const uint32_t flags = from->number(kFresnel | kMetallic, "flags of a finish");
    finish.fresnel = flags & kFresnel;
    finish.metallic = flags & kMetallic;
  }
  return finishes;
}

void apply_finishes(const std::vector<Finish>& finishes, const std::string& place, Scene* scene) {
  if (finishes.size() != scene->materials.size())
    throw BadInput(place + ": found finishes of " + std::to_string(finishes.size()) +
                   " materials, expected " + std::to_string(scene->materials.size()));
  for (size_t i = 0; i < finishes.size(); ++i) scene->materials[i].finish = finishes[i];
}

}  // namespace strad
