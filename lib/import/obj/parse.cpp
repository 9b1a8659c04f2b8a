// The only user of tinyobjloader.
#include "import/obj/parse.h"

#include <tiny_obj_loader.h>

#include <cstdlib>
#include <istream>
#include <map>
#include <streambuf>

#include "base/error.h"

namespace strad {
namespace {

// A stream that reads memory without a copy.
class ViewBuffer : public std::streambuf {
 public:
  explicit ViewBuffer(const std::string& text) {
    char* begin = const_cast<char*>(text.data());  // streambuf takes no const pointers; it is only read
    setg(begin, begin, begin + text.size());
  }
};

uint32_t place_in(const char* name) { return static_cast<uint32_t>(std::strtoul(name, nullptr, 10)); }

// The state of a parse. The next face belongs to `object` and `material`.
struct Gathering {
  ParsedObj obj;
  uint32_t object = 0, material = 0;
};

Gathering& gathering(void* user) { return *static_cast<Gathering*>(user); }

void take_face(void* user, tinyobj::index_t* indices, int count) {
  Gathering& to = gathering(user);
  to.obj.faces.push_back({to.obj.corners.size(), static_cast<uint32_t>(count), to.object, to.material});
  for (int i = 0; i < count; ++i) {
    // Numbers as in the file, from 1. 0 means none, and 0 - 1 is kNone.
    to.obj.corners.push_back({static_cast<uint32_t>(indices[i].vertex_index) - 1,
                              static_cast<uint32_t>(indices[i].texcoord_index) - 1,
                              static_cast<uint32_t>(indices[i].normal_index) - 1});
  }
}

tinyobj::callback_t callbacks() {
  tinyobj::callback_t calls;
  calls.vertex_cb = [](void* user, float x, float y, float z, float) {
    gathering(user).obj.vertices.push_back({x, y, z});
  };
  calls.texcoord_cb = [](void* user, float u, float v, float) { gathering(user).obj.uvs.push_back({u, v}); };
  calls.normal_cb = [](void* user, float x, float y, float z) {
    gathering(user).obj.normals.push_back({x, y, z});
  };
  calls.index_cb = take_face;
  calls.object_cb = [](void* user, const char* name) { gathering(user).object = place_in(name); };
  calls.usemtl_cb = [](void* user, const char* name, int) { gathering(user).material = place_in(name); };
  return calls;
}

}  // namespace

ParsedObj parse_clean_obj(const std::string& clean) {
  Gathering gathered;
  ViewBuffer buffer(clean);
  std::istream stream(&buffer);
  std::string warning, error;
  if (!tinyobj::LoadObjWithCallback(stream, callbacks(), &gathered, nullptr, &warning, &error))
    throw BadInput("tinyobjloader: " + error);
  return std::move(gathered.obj);
}

std::vector<ParsedMaterial> parse_clean_mtl(const std::string& clean, size_t count) {
  ViewBuffer buffer(clean);
  std::istream stream(&buffer);
  std::map<std::string, int> places;
  std::vector<tinyobj::material_t> found;
  std::string warning, error;
  tinyobj::LoadMtl(&places, &found, &stream, &warning, &error);
  std::vector<ParsedMaterial> materials(count);
  for (size_t i = 0; i < count; ++i) {
    const tinyobj::material_t& from = found[static_cast<size_t>(places.at(std::to_string(i)))];
    materials[i] = {{from.diffuse[0], from.diffuse[1], from.diffuse[2]},
                    {from.emission[0], from.emission[1], from.emission[2]}};
  }
  return materials;
}

}  // namespace strad
