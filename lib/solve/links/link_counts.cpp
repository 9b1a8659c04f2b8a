#include "solve/links/link_counts.h"

#include <algorithm>
#include <cmath>

#include "image/metrics.h"
#include "image/srgb.h"
#include "scene/trajectory.h"
#include "solve/links/leaves.h"
#include "stream/bytes.h"

namespace strad {
namespace {

// A leaf to be drawn.
struct Shape {
  PatchPoints at;  // world
  uint32_t links;
};

std::vector<Shape> shapes_of(const NodeTree& tree, const std::vector<uint32_t>& arriving) {
  const std::vector<Pose> poses = poses_at(tree.scene(), tree.scene().start);
  const auto nodes = static_cast<uint32_t>(tree.nodes().size());
  std::vector<Shape> shapes;
  for (const uint32_t leaf : leaves_of(tree)) {
    const uint32_t node = leaf < nodes ? leaf : tree.node_of_face(leaf - nodes);
    PatchPoints at = leaf < nodes ? patch_points(tree, tree.nodes()[leaf])
                                  : face_points(tree.scene(), tree.builder().mesh().faces[leaf - nodes]);
    for (int i = 0; i < at.corner_count; ++i) at.corners[i] = poses[tree.nodes()[node].body] * at.corners[i];
    shapes.push_back({at, arriving[node]});
  }
  return shapes;
}

Image colours_of(const std::vector<Shape>& shapes) {
  Image logarithms(static_cast<uint32_t>(shapes.size()), 1);
  float most = 0;
  for (size_t i = 0; i < shapes.size(); ++i) {
    const float l = std::log1p(static_cast<float>(shapes[i].links));
    logarithms.pixels[i] = {l, l, l};
    most = std::max(most, l);
  }
  return heat_map(Image(logarithms.width, 1), logarithms, most);
}

std::string header(size_t vertices, size_t faces) {
  return "ply\nformat binary_little_endian 1.0\ncomment strad: links that arrive; world, m\nelement vertex " +
         std::to_string(vertices) +
         "\nproperty float x\nproperty float y\nproperty float z\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face " +
         std::to_string(faces) +
         "\nproperty list uchar uint vertex_indices\nproperty uint links\nend_header\n";
}

}  // namespace

std::vector<uint32_t> arriving_links(const NodeTree& tree, const LinkTable& links) {
  std::vector<uint32_t> arriving(tree.nodes().size());
  for (size_t n = 0; n < arriving.size(); ++n) {  // parents come before their children
    arriving[n] =
        links.first_still[n + 1] - links.first_still[n] + links.first_dynamic[n + 1] - links.first_dynamic[n];
    const uint32_t parent = tree.nodes()[n].parent;
    if (parent != kNone) arriving[n] += arriving[parent];
  }
  return arriving;
}

std::string links_as_ply(const NodeTree& tree, const LinkTable& links) {
  const std::vector<Shape> shapes = shapes_of(tree, arriving_links(tree, links));
  const Image colours = colours_of(shapes);
  Bytes vertices, faces;
  uint32_t first = 0;
  for (size_t i = 0; i < shapes.size(); ++i) {
    const int count = shapes[i].at.corner_count;
    put_u8(&faces, static_cast<uint8_t>(count));
    for (int c = 0; c < count; ++c) {
      for (int axis = 0; axis < 3; ++axis)
        put_f32(&vertices, static_cast<float>(shapes[i].at.corners[c][axis]));
      for (int channel = 0; channel < 3; ++channel) put_u8(&vertices, srgb_byte(colours.pixels[i][channel]));
      put_u32(&faces, first++);
    }
    put_u32(&faces, shapes[i].links);
  }
  std::string ply = header(first, shapes.size());
  ply.append(vertices.begin(), vertices.end());
  ply.append(faces.begin(), faces.end());
  return ply;
}

}  // namespace strad
