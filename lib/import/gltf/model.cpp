#include "import/gltf/model.h"

#include "base/error.h"

namespace strad {

void set_roots(GltfModel* model, const std::vector<int>* named) {
  const auto fail = [&](size_t node, const std::string& what) {
    throw BadInput(model->file + ": node " + std::to_string(node) + " " + what);
  };
  std::vector<bool> has_parent(model->nodes.size()), is_root(model->nodes.size());
  for (const GltfNode& node : model->nodes) {
    for (const uint32_t child : node.children) {
      if (has_parent[child]) fail(child, "has two parents");
      has_parent[child] = true;
    }
  }
  if (named) {
    for (const int node : *named) {
      if (node < 0 || static_cast<size_t>(node) >= model->nodes.size())
        throw BadInput(model->file + ": the scene: uses node " + std::to_string(node) + " of " +
                       std::to_string(model->nodes.size()));
      const auto root = static_cast<uint32_t>(node);
      if (has_parent[root]) fail(root, "of the scene has a parent");
      if (is_root[root]) fail(root, "is named twice by the scene");
      is_root[root] = true;
      model->roots.push_back(root);
    }
    return;
  }
  for (uint32_t node = 0; node < model->nodes.size(); ++node)
    if (!has_parent[node]) model->roots.push_back(node);
}

}  // namespace strad
