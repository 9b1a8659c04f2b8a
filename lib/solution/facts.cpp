#include "solution/facts.h"

#include <charconv>
#include <map>

#include "solution/slab_work.h"

namespace strad {
namespace {

Fact number(double value) { return {value}; }
// A number that is stored as a float is printed with the fewest digits that give this float.
Fact number(float value) {
  char text[32];
  const char* end = std::to_chars(text, text + sizeof text, value).ptr;
  double shortest = 0;
  std::from_chars(text, end, shortest);
  return {shortest};
}
Fact number(size_t value) { return {static_cast<double>(value)}; }
Fact text(std::string value) { return {std::move(value)}; }
Fact point(Vec3 p) {
  const auto coordinate = [](double x) { return number(static_cast<float>(x)); };
  return {FactList{coordinate(p.x), coordinate(p.y), coordinate(p.z)}};
}
Fact colour(Rgb c) { return {FactList{number(c.r), number(c.g), number(c.b)}}; }

template <typename Item, typename Describe>
Fact list_of(const std::vector<Item>& items, Describe describe) {
  FactList list;
  for (const Item& item : items) list.push_back(describe(item));
  return {std::move(list)};
}

Fact bounds(const Scene& scene) {
  Box box;
  for (const Vec3& vertex : scene.vertices) box.add(vertex);
  if (box.empty()) return text("empty");
  return {FactGroup{{"lower", point(box.lower)}, {"upper", point(box.upper)}}};
}

// Emitted power in W per channel: pi Le area, over all front sides.
Fact emitters(const Scene& scene) {
  double count = 0, area = 0;
  Rgb power;
  for (const Polygon& polygon : scene.polygons) {
    if (!emits(scene, polygon)) continue;
    const double a = polygon_area(scene, polygon);
    ++count;
    area += a;
    power += static_cast<float>(kPi * a) * scene.materials[polygon.material].emission;
  }
  return {FactGroup{{"polygons", number(count)}, {"area m^2", number(area)}, {"power W", colour(power)}}};
}

Fact body(const Scene& scene, const Body& body) {
  double objects = 0;
  for (const Object& object : scene.objects) objects += &scene.bodies[object.body] == &body ? 1 : 0;
  return {FactGroup{{"name", text(body.name)},
                    {"on", text(scene.bodies[body.parent].name)},
                    {"objects", number(objects)},
                    {"keys", number(body.keys.size())}}};
}

Fact spot(const Scene& scene, const Spot& spot) {
  return {FactGroup{{"name", text(spot.name)},
                    {"on", text(scene.bodies[spot.body].name)},
                    {"inner degrees", number(spot.inner * 180 / kPi)},
                    {"outer degrees", number(spot.outer * 180 / kPi)},
                    {"keys", number(spot.keys.size())}}};
}

Fact material(const Scene& scene, const Material& material) {
  FactGroup group{{"name", text(material.name)}, {"reflectance", colour(material.reflectance)}};
  if (!is_black(material.emission)) group.push_back({"emission W/(sr m^2)", colour(material.emission)});
  if (material.texture != kNone) group.push_back({"texture", text(scene.textures[material.texture].name)});
  return {std::move(group)};
}

Fact glow(const Scene& scene, const Glow& glow) {
  return {
      FactGroup{{"material", text(scene.materials[glow.material].name)}, {"keys", number(glow.keys.size())}}};
}

Fact camera(const Camera& camera) {
  return {FactGroup{{"name", text(camera.name)}, {"keys", number(camera.keys.size())}}};
}

Fact scene_facts(const Scene& scene) {
  const auto size = [](const auto& items) { return number(items.size()); };
  return {FactGroup{
      {"polygons", size(scene.polygons)},
      {"vertices", size(scene.vertices)},
      {"objects", size(scene.objects)},
      {"textures", size(scene.textures)},
      {"bounds m", bounds(scene)},
      {"start s", number(scene.start)},
      {"end s", number(scene.end)},
      {"rate 1/s", number(scene.rate)},
      {"frames", number(static_cast<size_t>(frame_count(scene)))},
      {"emitters", emitters(scene)},
      {"materials", list_of(scene.materials, [&](const Material& m) { return material(scene, m); })},
      {"bodies", list_of(scene.bodies, [&](const Body& b) { return body(scene, b); })},
      {"spots", list_of(scene.spots, [&](const Spot& s) { return spot(scene, s); })},
      {"glows", list_of(scene.glows, [&](const Glow& g) { return glow(scene, g); })},
      {"cameras", list_of(scene.cameras, camera)}}};
}

double piece_count(const Slab& slab) {
  return static_cast<double>(slab.direct.pieces.size() + slab.indirect.pieces.size());
}

// Coefficients: three numbers per Gauss node of a piece.
double coefficient_count(const Slab& slab) {
  return 3 * static_cast<double>(slab.direct.coefficients.size() + slab.indirect.coefficients.size());
}

Fact slab_facts(const Slab& slab) {
  return {FactGroup{{"begin s", number(slab_begin(slab))},
                    {"end s", number(slab_end(slab))},
                    {"basis", text("m" + std::to_string(slab.grid.order))},
                    {"spans", number(slab.grid.spans.size())},
                    {"cells", number(size_t{slab.grid.cell_count()})},
                    {"vertices", number(slab.mesh.vertices.size())},
                    {"elements", number(slab.mesh.elements.size())},
                    {"faces", number(slab.mesh.faces.size())},
                    {"pieces", number(piece_count(slab))},
                    {"coefficients", number(coefficient_count(slab))}}};
}

Fact work_facts(const SlabWork& work) {
  const auto count = [](uint64_t n) { return number(static_cast<double>(n)); };
  return {FactGroup{{"begin s", number(work.begin)},
                    {"end s", number(work.end)},
                    {"clusters", count(work.clusters)},
                    {"links", count(work.links)},
                    {"links refined in time", count(work.links_refined_in_time)},
                    {"links refined in space", count(work.links_refined_in_space)},
                    {"kernel evaluations", count(work.kernel_evaluations)},
                    {"rays", count(work.rays)},
                    {"iterations", count(work.iterations)}}};
}

bool is_light(ChunkType type) { return type == kDirectChunk || type == kIndirectChunk; }

Fact solution_facts(const Solution& solution, const std::vector<ChunkFacts>& chunks) {
  double pieces = 0, coefficients = 0, light_bytes = 0, all_bytes = 0;
  for (const Slab& slab : solution.slabs) {
    pieces += piece_count(slab);
    coefficients += coefficient_count(slab);
  }
  for (const ChunkFacts& chunk : chunks) {
    const double bytes = static_cast<double>(chunk.stored + kChunkHeaderSize + kChecksumSize);
    if (is_light(chunk.type)) light_bytes += bytes;
    if (is_light(chunk.type) || chunk.type == kSlabChunk || chunk.type == kIndexChunk) all_bytes += bytes;
  }
  FactGroup group{{"begin s", number(slab_begin(solution.slabs.front()))},
                  {"end s", number(slab_end(solution.slabs.back()))},
                  {"pieces", number(pieces)},
                  {"coefficients", number(coefficients)},
                  {"bytes", number(all_bytes)}};
  if (coefficients > 0) {
    group.push_back({"light bytes per coefficient", number(light_bytes / coefficients)});
    group.push_back({"bytes per coefficient", number(all_bytes / coefficients)});
  }
  group.push_back({"slabs", list_of(solution.slabs, slab_facts)});
  return {std::move(group)};
}

Fact bytes_by_type(const std::vector<ChunkFacts>& chunks) {
  struct Sum {
    double count = 0, stored = 0, content = 0;
  };
  std::map<ChunkType, Sum> sums;
  for (const ChunkFacts& chunk : chunks) {
    Sum& sum = sums[chunk.type];
    ++sum.count;
    sum.stored += static_cast<double>(chunk.stored);
    sum.content += static_cast<double>(chunk.content);
  }
  FactList list;
  for (const auto& [type, sum] : sums)
    list.push_back({FactGroup{{"type", text(name_of(type))},
                              {"count", number(sum.count)},
                              {"stored bytes", number(sum.stored)},
                              {"content bytes", number(sum.content)}}});
  return {std::move(list)};
}

Fact chunk_facts(const ChunkFacts& chunk) {
  return {FactGroup{{"offset", number(size_t{chunk.offset})},
                    {"type", text(name_of(chunk.type))},
                    {"stored bytes", number(size_t{chunk.stored})},
                    {"content bytes", number(size_t{chunk.content})}}};
}

}  // namespace

Stream read_with_chunks(StreamReader& reader, std::vector<ChunkFacts>* chunks) {
  return read_stream(reader, [&](const ChunkView& chunk) {
    const uint64_t size = content_size(chunk.payload, reader.place(chunk));
    chunks->push_back({chunk.type, chunk.offset, chunk.payload.size(), size});
  });
}

Fact describe(const Stream& stream, const std::vector<ChunkFacts>& chunks, bool list_chunks) {
  FactGroup all{
      {"provenance", list_of(stream.scene.provenance, [](const std::string& s) { return text(s); })},
      {"scene", scene_facts(stream.scene)}};
  if (stream.solution) all.push_back({"solution", solution_facts(*stream.solution, chunks)});
  FactList work;
  for (const Chunk& chunk : stream.others)
    if (chunk.type == kWorkChunk) work.push_back(work_facts(decode_work(chunk.content, name_of(chunk.type))));
  if (!work.empty()) all.push_back({"work", {std::move(work)}});
  all.push_back({"bytes", bytes_by_type(chunks)});
  if (list_chunks) all.push_back({"chunks", list_of(chunks, chunk_facts)});
  return {std::move(all)};
}

}  // namespace strad
