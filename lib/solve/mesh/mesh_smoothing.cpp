#include "solve/mesh/mesh_smoothing.h"

#include <algorithm>

#include "base/parallel.h"
#include "solve/mesh/noise.h"

namespace strad {
namespace {

constexpr double kOpposite = 1e-3;  // of their distance: by so much two neighbours may fail to be opposite

// Divides the vertices with pairs into classes. No two vertices of a class are neighbours, so all of them can
// be changed in parallel (greedy colouring).
std::vector<std::vector<uint32_t>> independent_classes(const std::vector<std::vector<NeighbourPair>>& pairs) {
  std::vector<uint32_t> class_of(pairs.size(), kNone);
  std::vector<std::vector<uint32_t>> users(pairs.size());  // vertices that have it as a neighbour
  for (uint32_t v = 0; v < pairs.size(); ++v)
    for (const NeighbourPair& pair : pairs[v])
      for (const uint32_t n : {pair.a, pair.b}) users[n].push_back(v);
  std::vector<std::vector<uint32_t>> classes;
  for (uint32_t v = 0; v < pairs.size(); ++v) {
    if (pairs[v].empty()) continue;
    std::vector<bool> taken(classes.size() + 1, false);
    const auto avoid = [&](uint32_t n) {
      if (class_of[n] != kNone) taken[class_of[n]] = true;
    };
    for (const NeighbourPair& pair : pairs[v]) avoid(pair.a), avoid(pair.b);
    for (const uint32_t n : users[v]) avoid(n);
    class_of[v] = static_cast<uint32_t>(std::find(taken.begin(), taken.end(), false) - taken.begin());
    if (class_of[v] == classes.size()) classes.emplace_back();
    classes[class_of[v]].push_back(v);
  }
  return classes;
}

// The mean of a pair minus the vertex's own function.
std::vector<Rgb> difference_of(const std::vector<Rgb>& own, const CoarseFunction& a,
                               const CoarseFunction& b) {
  std::vector<Rgb> difference(own.size());
  for (size_t t = 0; t < own.size(); ++t) difference[t] = 0.5f * (a[t] + b[t]) - own[t];
  return difference;
}

double usual_difference(const std::vector<std::vector<NeighbourPair>>& pairs,
                        const std::function<CoarseFunction&(uint32_t vertex)>& function) {
  std::vector<size_t> first{0};
  for (const auto& own : pairs) first.push_back(first.back() + own.size());
  std::vector<double> sizes(first.back());
  parallel_for(pairs.size(), 64, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v) {
      if (pairs[v].empty()) continue;
      const std::vector<Rgb> own = function(static_cast<uint32_t>(v)).unpacked();
      for (size_t i = 0; i < pairs[v].size(); ++i)
        sizes[first[v] + i] =
            relative_rms(difference_of(own, function(pairs[v][i].a), function(pairs[v][i].b)), own);
    }
  });
  return median_of(&sizes);
}

}  // namespace

std::vector<std::vector<NeighbourPair>> opposite_neighbours(const Mesh& mesh,
                                                            const std::vector<uint32_t>& elements,
                                                            double farthest) {
  std::vector<std::vector<uint32_t>> neighbours(mesh.vertices.size());
  for (const uint32_t element : elements) {
    const Element& e = mesh.elements[element];
    const int n = e.corner_count();
    for (int i = 0; i < n; ++i) {
      const uint32_t a = e.vertices[i], b = e.vertices[(i + 1) % n];
      if (length(mesh.vertices[a].position - mesh.vertices[b].position) > farthest) continue;
      neighbours[a].push_back(b);
      neighbours[b].push_back(a);
    }
  }
  std::vector<std::vector<NeighbourPair>> pairs(mesh.vertices.size());
  for (uint32_t v = 0; v < neighbours.size(); ++v) {
    std::vector<uint32_t>& around = neighbours[v];
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    const auto from_v = [&](uint32_t n) { return mesh.vertices[n].position - mesh.vertices[v].position; };
    for (size_t i = 0; i < around.size(); ++i)
      for (size_t j = i + 1; j < around.size(); ++j)
        if (length(from_v(around[i]) + from_v(around[j])) < kOpposite * length(from_v(around[i])))
          pairs[v].push_back({around[i], around[j]});
  }
  return pairs;
}

void smooth(const std::vector<std::vector<NeighbourPair>>& pairs,
            const std::function<CoarseFunction&(uint32_t vertex)>& function) {
  const std::vector<std::vector<uint32_t>> classes = independent_classes(pairs);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const double usual = usual_difference(pairs, function);
    for (const std::vector<uint32_t>& vertices : classes) {
      parallel_for(vertices.size(), 16, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
          const std::vector<NeighbourPair>& own_pairs = pairs[vertices[i]];
          const std::vector<Rgb> own = function(vertices[i]).unpacked();
          std::vector<Rgb> result = own;
          const float share = 0.5f / static_cast<float>(std::max<size_t>(2, own_pairs.size()));
          for (const NeighbourPair& pair : own_pairs) {
            const std::vector<Rgb> difference = difference_of(own, function(pair.a), function(pair.b));
            const float part = share * share_of_noise(relative_rms(difference, own), usual);
            for (size_t t = 0; t < own.size(); ++t) result[t] += part * difference[t];
          }
          function(vertices[i]) = CoarseFunction(result);
        }
      });
    }
  }
}

}  // namespace strad
