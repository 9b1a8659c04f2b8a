#include "solve/links/leaves.h"

#include "base/parallel.h"

namespace strad {

LeafSurface surface_of(const NodeTree& tree, uint32_t leaf) {
  const auto inverse_pi = static_cast<float>(1 / kPi);
  if (leaf < tree.nodes().size()) {
    const Node& node = tree.nodes()[leaf];
    return {node.element, node.area, inverse_pi * node.reflectance};
  }
  const uint32_t f = leaf - static_cast<uint32_t>(tree.nodes().size());
  const Face& face = tree.builder().mesh().faces[f];
  const Material& material = tree.scene().materials[tree.scene().polygons[face.polygon].material];
  return {face.element, tree.face_area(f), inverse_pi * material.reflectance};
}

std::vector<uint32_t> leaves_of(const NodeTree& tree) {
  std::vector<uint32_t> leaves;
  const auto nodes = static_cast<uint32_t>(tree.nodes().size());
  for (uint32_t n = 0; n < nodes; ++n)
    if (tree.nodes()[n].is_leaf() && !tree.nodes()[n].is_cluster()) leaves.push_back(n);
  for (uint32_t leaf = nodes; leaf < tree.leaf_count(); ++leaf)
    if (tree.nodes()[tree.node_of_face(leaf - nodes)].is_cluster()) leaves.push_back(leaf);
  return leaves;
}

double total_of(const NodeTree& tree, const FunctionBlock& radiance) {
  double total = 0;
  for (const uint32_t leaf : radiance.rows()) {
    double of_leaf = 0;
    for (size_t t = 0; t < radiance.sample_count(); ++t) {
      const Rgb l = radiance.get(leaf, t);
      of_leaf += l.r + l.g + l.b;
    }
    total += surface_of(tree, leaf).area * of_leaf;
  }
  return total;
}

std::vector<double> means_over_time(const FunctionBlock& radiance) {
  std::vector<double> means(radiance.rows().size());
  parallel_for(means.size(), 64, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      for (size_t t = 0; t < radiance.sample_count(); ++t)
        means[i] += mean_channel(radiance.get(radiance.rows()[i], t));
      means[i] /= static_cast<double>(radiance.sample_count());
    }
  });
  return means;
}

double mean_radiance(const NodeTree& tree, const FunctionBlock& radiance) {
  const std::vector<double> means = means_over_time(radiance);
  double sum = 0, area = 0;
  for (size_t i = 0; i < means.size(); ++i) {
    if (!(means[i] > 0)) continue;
    const double a = surface_of(tree, radiance.rows()[i]).area;
    sum += a * means[i];
    area += a;
  }
  return area > 0 ? sum / area : 0;
}

}  // namespace strad
