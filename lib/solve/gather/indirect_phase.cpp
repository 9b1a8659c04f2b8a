#include "solve/gather/indirect_phase.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include "base/memory.h"
#include "base/parallel.h"
#include "solve/mesh/undivided_rows.h"

namespace strad {
namespace {

int parent_count(const MeshVertex& vertex) { return vertex.parent_count(); }

template <typename Function>
float unblocked_of(const Function& function, size_t time_sample) {
  return function.unblocked.empty() ? 1.0f : function.unblocked[time_sample];
}

// Where the view of `own` is blocked, gives it what those of `others` have that are free.
template <typename Function>
void fill(const std::vector<const Function*>& others, GatheredFunction* own) {
  constexpr float kTrusted = 0.6f;  // from here on a view speaks for itself
  for (size_t i = 0; i < own->unblocked.size(); ++i) {
    if (own->unblocked[i] >= kTrusted) continue;
    Rgb sum;
    float weight = 0;
    for (const Function* other : others) {
      const float w = std::max(0.0f, unblocked_of(*other, i) - 0.55f);
      sum += w * other->irradiance[i];
      weight += w;
    }
    if (!(weight > 0)) continue;
    const float part = std::clamp((own->unblocked[i] - 0.5f) / (kTrusted - 0.5f), 0.0f, 1.0f);
    own->irradiance[i] = part * own->irradiance[i] + ((1 - part) / weight) * sum;
    own->unblocked[i] = kTrusted;
  }
}

}  // namespace

IndirectPhase::IndirectPhase(const Scene& scene, const TimeGrid& grid, const FinalGather& gather,
                             const IndirectOptions& options, MeshBuilder* builder)
    : scene_(scene), grid_(grid), gather_(gather), options_(options), builder_(*builder) {
  for (const Polygon& polygon : scene.polygons) total_area_ += polygon_area(scene, polygon);
}

void IndirectPhase::evaluate(const std::vector<uint32_t>& vertices) {
  functions_.resize(builder_.mesh().vertices.size());
  std::vector<uint32_t> fresh;
  for (const uint32_t v : vertices)
    if (functions_[v].irradiance.empty()) fresh.push_back(v);
  std::sort(fresh.begin(), fresh.end());
  fresh.erase(std::unique(fresh.begin(), fresh.end()), fresh.end());
  std::vector<uint64_t> rays(fresh.size(), 0);
  parallel_for(fresh.size(), 4, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      GatheredFunction f = gather_.at_vertex(fresh[i], &rays[i]);
      functions_[fresh[i]] = {CoarseFunction(f.irradiance), std::move(f.unblocked)};
    }
  });
  rays_ += std::accumulate(rays.begin(), rays.end(), uint64_t{0});
}

std::vector<Rgb> IndirectPhase::parents_mean(uint32_t vertex) const {
  const MeshVertex& v = builder_.mesh().vertices[vertex];
  const int count = parent_count(v);
  std::vector<Rgb> mean(grid_.sample_count());
  for (int p = 0; p < count; ++p) {
    // A parent without a function of its own (it hangs, or belongs to direct light alone) is the mean of its
    // own.
    const CoarseFunction& own = functions_[v.parents[p]].irradiance;
    const std::vector<Rgb> of_parent = own.empty() ? parents_mean(v.parents[p]) : own.unpacked();
    for (size_t i = 0; i < mean.size(); ++i) mean[i] += (1.0f / static_cast<float>(count)) * of_parent[i];
  }
  return mean;
}

// Does the foot of something cross the element at some time sample? Light there changes too fast to be told
// from a few vertices, half of which see nothing.
bool IndirectPhase::is_partly_blocked(uint32_t element) const {
  const Element& e = builder_.mesh().elements[element];
  uint32_t vertices[9];
  int count = builder_.middles(element, vertices);
  for (int i = 0; i < e.corner_count(); ++i) vertices[count++] = e.vertices[i];
  const bool any =
      std::any_of(vertices, vertices + count, [&](uint32_t v) { return !functions_[v].unblocked.empty(); });
  if (!any) return false;
  for (size_t i = 0; i < grid_.sample_count(); ++i) {
    int blocked = 0, known = 0;
    for (int v = 0; v < count; ++v) {
      if (functions_[vertices[v]].irradiance.empty()) continue;
      ++known;
      blocked += unblocked_of(functions_[vertices[v]], i) < 0.5f;
    }
    if (blocked > 0 && blocked < known) return true;
  }
  return false;
}

// The largest irradiance at the corners over time, by what an error counts there.
float IndirectPhase::brightest_at_corners(uint32_t element) const {
  const Element& e = builder_.mesh().elements[element];
  float most = 0;
  for (int i = 0; i < e.corner_count(); ++i)
    for (const Rgb& value : functions_[e.vertices[i]].irradiance.unpacked())
      most = std::max(most, max_channel(value) * weight_of(value));
  return most;
}

// What an error counts where the irradiance is this: 1 where it is bright.
float IndirectPhase::weight_of(Rgb irradiance) const {
  const float local = std::max(max_channel(irradiance), options_.dark);
  return local < options_.bright ? options_.bright / local : 1;
}

// Do the vertices that splitting this element has added differ from what their parents interpolated?
bool IndirectPhase::worth_splitting(uint32_t element) const {
  const Mesh& mesh = builder_.mesh();
  const Element& e = mesh.elements[element];
  const auto at = [&](int i) { return mesh.vertices[e.vertices[i]].position; };
  const double edge = std::max(length(at(1) - at(0)), length(at(2) - at(1)));
  if (edge < 2 * options_.smallest_element) return false;
  if (edge > 2 * options_.largest_element) return true;
  const Polygon& polygon = scene_.polygons[mesh.faces[builder_.face_of(element)].polygon];
  const double area = length(cross(at(1) - at(0), at(2) - at(0))) * (e.corner_count() == 4 ? 1 : 0.5);
  const auto scale = static_cast<float>(max_channel(scene_.materials[polygon.material].reflectance) / kPi *
                                        std::sqrt(0.25 * area / total_area_));
  if (scale * brightest_at_corners(element) > options_.threshold && is_partly_blocked(element)) return true;
  uint32_t middles[5];
  const int count = builder_.middles(element, middles);
  for (int m = 0; m < count; ++m) {
    const std::vector<Rgb> interpolated = parents_mean(middles[m]);
    const VertexFunction& own = functions_[middles[m]];
    for (size_t i = 0; i < interpolated.size(); ++i) {
      float unblocked = unblocked_of(own, i);
      for (int p = 0; p < parent_count(mesh.vertices[middles[m]]); ++p)
        unblocked = std::min(unblocked, unblocked_of(functions_[mesh.vertices[middles[m]].parents[p]], i));
      if (unblocked < 0.5f) continue;  // buried: what is known there is not light
      const Rgb surplus = own.irradiance[i] - interpolated[i];
      if (std::max({std::abs(surplus.r), std::abs(surplus.g), std::abs(surplus.b)}) * scale *
              weight_of(interpolated[i]) >
          options_.threshold)
        return true;
    }
  }
  return false;
}

void IndirectPhase::run() {
  const Mesh& mesh = builder_.mesh();
  const Tolerance tolerance = [&](uint32_t vertex, const std::vector<Rgb>& irradiance) {
    return tolerance_for(vertex, irradiance);
  };
  undivided_rows_ = rows_of_undivided_faces(
      grid_, builder_, tolerance,
      [&](uint32_t face, uint64_t* rays) { return gather_undivided_face(face, rays); }, &rays_);
  undivided_rows_ = denoise_uniform_faces(grid_, builder_, tolerance, std::move(undivided_rows_));
  release_freed_memory();  // their rays and rows were many small things
  std::vector<uint32_t> level, vertices;
  for (uint32_t f = builder_.undivided_faces(); f < mesh.faces.size(); ++f) {
    level.push_back(mesh.faces[f].element);
    for (int c = 0; c < mesh.elements[level.back()].corner_count(); ++c)
      vertices.push_back(mesh.elements[level.back()].vertices[c]);
  }
  evaluate(vertices);
  visited_ = level;
  while (!level.empty()) {
    std::vector<uint32_t> split;
    vertices.clear();
    for (const uint32_t element : level) {
      const Element& e = mesh.elements[element];
      const double edge =
          std::max(length(mesh.vertices[e.vertices[1]].position - mesh.vertices[e.vertices[0]].position),
                   length(mesh.vertices[e.vertices[2]].position - mesh.vertices[e.vertices[1]].position));
      if (edge < options_.smallest_element) continue;
      if (e.first_child == kNone) builder_.split(element);
      split.push_back(element);
      uint32_t middles[5];
      const int count = builder_.middles(element, middles);
      vertices.insert(vertices.end(), middles, middles + count);
    }
    evaluate(vertices);
    std::vector<char> deeper(split.size());
    parallel_for(split.size(), 16, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) deeper[i] = worth_splitting(split[i]);
    });
    std::vector<uint32_t> next;
    for (size_t i = 0; i < split.size(); ++i)
      for (uint32_t c = 0; c < 4; ++c) {
        const uint32_t child = mesh.elements[split[i]].first_child + c;
        visited_.push_back(child);
        if (deeper[i]) next.push_back(child);
      }
    level = std::move(next);
  }
}

// A vertex inside another body sees nothing but its dark inside: give it what its free neighbours have, so
// that no dark cell shows at the foot of things. Those farther inside follow, for they may be parents of what
// is seen.
void IndirectPhase::fill_blocked_vertices() {
  const Mesh& mesh = builder_.mesh();
  std::vector<uint32_t> blocked, rank(functions_.size(), kNone);
  for (uint32_t v = 0; v < functions_.size(); ++v) {
    if (functions_[v].unblocked.empty()) continue;
    rank[v] = static_cast<uint32_t>(blocked.size());
    blocked.push_back(v);
  }
  std::vector<std::vector<uint32_t>> neighbours(blocked.size());
  for (const uint32_t element : visited_) {
    const Element& e = mesh.elements[element];
    const int n = e.corner_count();
    for (int i = 0; i < n; ++i) {
      const uint32_t a = e.vertices[i], b = e.vertices[(i + 1) % n];
      if (rank[a] != kNone) neighbours[rank[a]].push_back(b);
      if (rank[b] != kNone) neighbours[rank[b]].push_back(a);
    }
  }
  constexpr int kRounds = 16;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<VertexFunction> filled(blocked.size());
    parallel_for(blocked.size(), 8, [&](size_t begin, size_t end) {
      for (size_t b = begin; b < end; ++b) filled[b] = filled_from(blocked[b], neighbours[b]);
    });
    for (size_t b = 0; b < blocked.size(); ++b) functions_[blocked[b]] = std::move(filled[b]);
  }
}

IndirectPhase::VertexFunction IndirectPhase::filled_from(uint32_t vertex,
                                                         const std::vector<uint32_t>& neighbours) const {
  GatheredFunction own{functions_[vertex].irradiance.unpacked(), functions_[vertex].unblocked};
  std::vector<const VertexFunction*> others;
  for (const uint32_t n : neighbours)
    if (!functions_[n].irradiance.empty()) others.push_back(&functions_[n]);
  fill(others, &own);
  return {CoarseFunction(own.irradiance), std::move(own.unblocked)};
}

// The vertices of a face that is never split fill one another.
std::vector<std::vector<Rgb>> IndirectPhase::gather_undivided_face(uint32_t face, uint64_t* rays) const {
  std::vector<GatheredFunction> found;
  const auto [first, count] = vertices_of_undivided(builder_.mesh(), face);
  for (uint32_t v = first; v < first + count; ++v) found.push_back(gather_.at_vertex(v, rays));
  std::vector<const GatheredFunction*> all;
  for (const GatheredFunction& function : found) all.push_back(&function);
  std::vector<std::vector<Rgb>> rows;
  for (const GatheredFunction& function : found) {
    GatheredFunction own = function;
    fill(all, &own);
    rows.push_back(std::move(own.irradiance));
  }
  return rows;
}

// For each vertex the last one whose surplus asks for its function.
std::vector<uint32_t> IndirectPhase::last_users_of_functions() const {
  const Mesh& mesh = builder_.mesh();
  std::vector<uint32_t> last_user(mesh.vertices.size());
  const std::function<void(uint32_t, uint32_t)> use = [&](uint32_t vertex, uint32_t user) {
    last_user[vertex] = user;
    if (!functions_[vertex].irradiance.empty()) return;
    for (int p = 0; p < parent_count(mesh.vertices[vertex]); ++p) use(mesh.vertices[vertex].parents[p], user);
  };
  for (uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    last_user[v] = v;
    if (functions_[v].irradiance.empty()) continue;
    for (int p = 0; p < parent_count(mesh.vertices[v]); ++p) use(mesh.vertices[v].parents[p], v);
  }
  return last_user;
}

// W / m^2: by the mean over time of what an error counts.
float IndirectPhase::tolerance_for(uint32_t vertex, const std::vector<Rgb>& irradiance) const {
  double sum = 0;
  for (const Rgb& e : irradiance) sum += weight_of(e);
  const auto weight = static_cast<float>(sum / static_cast<double>(irradiance.size()));
  return tolerance_of(builder_, vertex, options_.tolerance / weight);
}

Field IndirectPhase::take_surpluses() {
  const Mesh& mesh = builder_.mesh();
  functions_.resize(mesh.vertices.size());
  fill_blocked_vertices();
  const std::vector<bool> hanging = builder_.hanging_vertices();
  for (size_t v = 0; v < hanging.size(); ++v)
    if (hanging[v]) functions_[v] = {};
  const std::vector<uint32_t> last_users = last_users_of_functions();
  std::vector<uint32_t> by_last_user(mesh.vertices.size());
  std::iota(by_last_user.begin(), by_last_user.end(), 0u);
  std::sort(by_last_user.begin(), by_last_user.end(), [&](uint32_t a, uint32_t b) {
    return std::pair(last_users[a], a) < std::pair(last_users[b], b);
  });
  auto done = by_last_user.begin();
  Field field = std::move(undivided_rows_);
  for (uint32_t v = builder_.undivided_vertices(); v < mesh.vertices.size(); ++v) {
    // Functions go as their rows come, and their pages with them.
    for (; done != by_last_user.end() && last_users[*done] < v; ++done) functions_[*done] = {};
    if (v % 4096 == 0) release_freed_memory();
    const CoarseFunction& own = functions_[v].irradiance;
    if (own.empty()) {
      if (parent_count(mesh.vertices[v]) == 0)
        functions_[v].irradiance = CoarseFunction(std::vector<Rgb>(grid_.sample_count()));
      field.first_piece.push_back(static_cast<uint32_t>(field.pieces.size()));
      continue;
    }
    std::vector<Rgb> row = own.unpacked();
    const std::vector<Rgb> irradiance = row;
    if (parent_count(mesh.vertices[v]) > 0) {
      const std::vector<Rgb> mean = parents_mean(v);
      for (size_t i = 0; i < row.size(); ++i) row[i] = row[i] - mean[i];
    }
    append_row(grid_, row, {}, tolerance_for(v, irradiance), &field);
  }
  return field;
}

}  // namespace strad
