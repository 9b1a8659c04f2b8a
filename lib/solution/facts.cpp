#include "solution/facts.h"

#include <map>

#include "solution/fact_values.h"
#include "solution/object_facts.h"
#include "solution/slab_work.h"

namespace strad {
namespace {

Fact bounds(const Scene& scene) {
  Box box;
  for (const Vec3& vertex : scene.vertices) box.add(vertex);
  return box_fact(box);
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
  return {FactGroup{
      {"polygons", number_fact(count)}, {"area m^2", number_fact(area)}, {"power W", colour_fact(power)}}};
}

Fact body(const Scene& scene, const Body& body) {
  double objects = 0;
  for (const Object& object : scene.objects) objects += &scene.bodies[object.body] == &body ? 1 : 0;
  return {FactGroup{{"name", text_fact(body.name)},
                    {"on", text_fact(scene.bodies[body.parent].name)},
                    {"objects", number_fact(objects)},
                    {"keys", number_fact(body.keys.size())}}};
}

Fact spot(const Scene& scene, const Spot& spot) {
  return {FactGroup{{"name", text_fact(spot.name)},
                    {"on", text_fact(scene.bodies[spot.body].name)},
                    {"inner degrees", number_fact(spot.inner * 180 / kPi)},
                    {"outer degrees", number_fact(spot.outer * 180 / kPi)},
                    {"keys", number_fact(spot.keys.size())}}};
}

Fact material(const Scene& scene, const Material& material) {
  FactGroup group{{"name", text_fact(material.name)}, {"reflectance", colour_fact(material.reflectance)}};
  if (!is_black(material.emission)) group.push_back({"emission W/(sr m^2)", colour_fact(material.emission)});
  if (material.texture != kNone)
    group.push_back({"texture", text_fact(scene.textures[material.texture].name)});
  return {std::move(group)};
}

Fact glow(const Scene& scene, const Glow& glow) {
  return {FactGroup{{"material", text_fact(scene.materials[glow.material].name)},
                    {"keys", number_fact(glow.keys.size())}}};
}

Fact camera(const Camera& camera) {
  return {FactGroup{{"name", text_fact(camera.name)}, {"keys", number_fact(camera.keys.size())}}};
}

Fact scene_facts(const Scene& scene) {
  const auto size = [](const auto& items) { return number_fact(items.size()); };
  return {FactGroup{
      {"polygons", size(scene.polygons)},
      {"vertices", size(scene.vertices)},
      {"objects", size(scene.objects)},
      {"textures", size(scene.textures)},
      {"bounds m", bounds(scene)},
      {"start s", number_fact(scene.start)},
      {"end s", number_fact(scene.end)},
      {"rate 1/s", number_fact(scene.rate)},
      {"frames", number_fact(static_cast<size_t>(frame_count(scene)))},
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
  return {FactGroup{{"begin s", number_fact(slab_begin(slab))},
                    {"end s", number_fact(slab_end(slab))},
                    {"basis", text_fact("m" + std::to_string(slab.grid.order))},
                    {"spans", number_fact(slab.grid.spans.size())},
                    {"cells", number_fact(size_t{slab.grid.cell_count()})},
                    {"vertices", number_fact(slab.mesh.vertices.size())},
                    {"elements", number_fact(slab.mesh.elements.size())},
                    {"faces", number_fact(slab.mesh.faces.size())},
                    {"pieces", number_fact(piece_count(slab))},
                    {"coefficients", number_fact(coefficient_count(slab))}}};
}

Fact work_facts(const SlabWork& work) {
  const auto count = [](uint64_t n) { return number_fact(static_cast<double>(n)); };
  return {FactGroup{{"begin s", number_fact(work.begin)},
                    {"end s", number_fact(work.end)},
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
  FactGroup group{{"begin s", number_fact(slab_begin(solution.slabs.front()))},
                  {"end s", number_fact(slab_end(solution.slabs.back()))},
                  {"pieces", number_fact(pieces)},
                  {"coefficients", number_fact(coefficients)},
                  {"bytes", number_fact(all_bytes)}};
  if (coefficients > 0) {
    group.push_back({"light bytes per coefficient", number_fact(light_bytes / coefficients)});
    group.push_back({"bytes per coefficient", number_fact(all_bytes / coefficients)});
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
    list.push_back({FactGroup{{"type", text_fact(name_of(type))},
                              {"count", number_fact(sum.count)},
                              {"stored bytes", number_fact(sum.stored)},
                              {"content bytes", number_fact(sum.content)}}});
  return {std::move(list)};
}

Fact chunk_facts(const ChunkFacts& chunk) {
  return {FactGroup{{"offset", number_fact(size_t{chunk.offset})},
                    {"type", text_fact(name_of(chunk.type))},
                    {"stored bytes", number_fact(size_t{chunk.stored})},
                    {"content bytes", number_fact(size_t{chunk.content})}}};
}

}  // namespace

Stream read_with_chunks(StreamReader& reader, std::vector<ChunkFacts>* chunks) {
  return read_stream(reader, [&](const ChunkView& chunk) {
    const uint64_t size = content_size(chunk.payload, reader.place(chunk));
    chunks->push_back({chunk.type, chunk.offset, chunk.payload.size(), size});
  });
}

Fact describe(const Stream& stream, const std::vector<ChunkFacts>& chunks, const FactChoice& choice) {
  FactGroup all{
      {"provenance", list_of(stream.scene.provenance, [](const std::string& s) { return text_fact(s); })},
      {"scene", scene_facts(stream.scene)}};
  if (choice.objects) all.push_back({"objects", object_facts(stream.scene)});
  if (stream.solution) all.push_back({"solution", solution_facts(*stream.solution, chunks)});
  FactList work;
  for (const Chunk& chunk : stream.others)
    if (chunk.type == kWorkChunk) work.push_back(work_facts(decode_work(chunk.content, name_of(chunk.type))));
  if (!work.empty()) all.push_back({"work", {std::move(work)}});
  all.push_back({"bytes", bytes_by_type(chunks)});
  if (choice.chunks) all.push_back({"chunks", list_of(chunks, chunk_facts)});
  return {std::move(all)};
}

}  // namespace strad
