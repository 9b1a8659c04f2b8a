// Reads POV-Ray's objects that are surfaces of functions: quadric and higher polynomials, blob, isosurface;
// and bicubic patches.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "import/pov/csg.h"
#include "import/pov/implicit.h"
#include "import/pov/scene_reader.h"
#include "import/pov/shapes.h"
#include "import/pov/solids.h"

namespace strad {
namespace {

// The value of a polynomial. Its coefficients come by falling powers of x, then of y, then of z.
double polynomial(const std::vector<double>& coefficients, int order, Vec3 p) {
  size_t next = 0;
  double sum = 0, px = std::pow(p.x, order);
  const auto power = [](double base, int exponent) {
    double product = 1;
    for (int i = 0; i < exponent; ++i) product *= base;
    return product;
  };
  for (int a = order; a >= 0; --a) {
    px = power(p.x, a);
    for (int b = order - a; b >= 0; --b) {
      const double pxy = px * power(p.y, b);
      for (int c = order - a - b; c >= 0; --c, ++next)
        if (coefficients[next] != 0) sum += coefficients[next] * pxy * power(p.z, c);
    }
  }
  return sum;
}

struct BlobPart {
  Vec3 from, to;  // the same for a sphere
  double radius = 0, strength = 1;
  PovTransform back;  // from the blob's space to the part's
  double at(Vec3 p) const {
    p = back.point(p);
    const Vec3 along = to - from;
    const double l2 = length2(along);
    const double s = l2 > 0 ? std::clamp(dot(p - from, along) / l2, 0.0, 1.0) : 0;
    const double d2 = length2(p - from - s * along) / (radius * radius);
    return d2 < 1 ? strength * (1 - d2) * (1 - d2) : 0;
  }
};

}  // namespace

PovObject PovSceneReader::polynomial_shape(const std::string& kind) {
  PovPending pending;
  pending.kind = kind;
  if (kind == "quadric") {
    std::array<double, 10> q{};
    for (size_t i = 0; i < 9; i += 3) {
      const Vec3 part = in_.vector();
      in_.skip_comma();
      q[i] = part.x, q[i + 1] = part.y, q[i + 2] = part.z;
    }
    q[9] = in_.number();
    pending.field = [q](Vec3 p) {
      return q[0] * p.x * p.x + q[1] * p.y * p.y + q[2] * p.z * p.z + q[3] * p.x * p.y + q[4] * p.x * p.z +
             q[5] * p.y * p.z + q[6] * p.x + q[7] * p.y + q[8] * p.z + q[9];
    };
  } else {
    int order = kind == "cubic" ? 3 : 4;
    if (kind == "poly") {
      order = in_.integer();
      in_.skip_comma();
      if (order < 2 || order > 35)
        in_.fail("a poly has the order " + std::to_string(order) + ", expected 2 to 35");
    }
    const auto count = static_cast<size_t>((order + 1) * (order + 2) * (order + 3) / 6);
    std::vector<double> coefficients;
    in_.expect("<");
    while (coefficients.size() < count) {
      coefficients.push_back(in_.number());
      in_.skip_comma();
    }
    in_.expect(">");
    pending.field = [coefficients, order](Vec3 p) { return polynomial(coefficients, order, p); };
  }
  PovObject made;
  made.pending = std::move(pending);
  return made;
}

// blob { [threshold T] sphere { centre, radius, [strength] S modifiers } cylinder { from, to, radius, S } ...
// }
PovObject PovSceneReader::blob_shape() {
  const PovPlace at = in_.place();
  double threshold = 1;
  std::vector<BlobPart> parts;
  Box box;
  const auto reach = [&box](const BlobPart& part, const PovTransform& placed) {
    for (const Vec3 end : {part.from, part.to})
      for (int corner = 0; corner < 8; ++corner)
        box.add(placed.point(end + part.radius * Vec3{corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0,
                                                      corner & 4 ? 1.0 : -1.0}));
  };
  while (in_.next_is("threshold") || in_.next_is("sphere") || in_.next_is("cylinder") ||
         in_.next_is("component")) {
    const std::string word(in_.take().text);
    if (word == "threshold") {
      threshold = in_.number();
      continue;
    }
    BlobPart part;
    if (word == "component") {  // an old form: strength, radius, centre
      part.strength = in_.number();
      in_.skip_comma();
      part.radius = std::abs(in_.number());
      in_.skip_comma();
      part.from = part.to = in_.vector();
      if (part.radius > 0) reach(part, {}), parts.push_back(part);
      continue;
    }
    in_.expect("{");
    part.from = part.to = in_.vector();
    in_.skip_comma();
    if (word == "cylinder") part.to = in_.vector(), in_.skip_comma();
    part.radius = std::abs(in_.number());
    in_.skip_comma();
    if (in_.take_if("strength") || in_.expression_is_next()) part.strength = in_.number();
    PovTransform placed;
    while (!in_.take_if("}")) {
      if (in_.take_if(",") || transformation(&placed)) continue;
      if (in_.peek().kind != PovKind::kWord) in_.fail_expected("a modifier of a blob's part or }");
      if (in_.next_is("texture") || in_.next_is("pigment"))
        report_->add("a blob has one texture: those of its parts are ignored", at.file, in_.place().line);
      in_.skip_item();
    }
    if (!(part.radius > 0)) continue;
    part.back = inverse_of(placed);
    reach(part, placed);
    parts.push_back(part);
  }
  if (parts.empty()) fail_at(at.file, at.line, "a blob has no parts");
  return pov_implicit(
      [parts, threshold](Vec3 p) {
        double sum = 0;
        for (const BlobPart& part : parts) sum += part.at(p);
        return threshold - sum;
      },
      box, cells());
}

PovObject PovSceneReader::isosurface_shape() {
  const PovPlace at = in_.place();
  if (!in_.take_if("function")) in_.fail_expected("function");
  const PovFunction function = in_.function_value();
  in_.note_use(function);
  double threshold = 0;
  PovObject container = pov_box({-1, -1, -1}, {1, 1, 1});
  bool open = false;
  while (in_.peek().kind == PovKind::kWord) {
    if (in_.take_if("threshold")) {
      threshold = in_.number();
    } else if (in_.take_if("contained_by")) {
      in_.expect("{");
      container = object();
      in_.expect("}");
    } else if (in_.take_if("open")) {
      open = true;
    } else if (in_.next_is("accuracy") || in_.next_is("max_gradient") || in_.next_is("evaluate") ||
               in_.next_is("max_trace") || in_.next_is("all_intersections")) {
      in_.skip_item();
    } else {
      break;
    }
  }
  Box box;
  for (const Vec3 p : container.points) box.add(p);
  if (box.empty()) fail_at(at.file, at.line, "an isosurface is contained by nothing");
  const Vec3 margin = 0.05 * (box.upper - box.lower);
  Box wider = box;
  wider.add(box.lower - margin), wider.add(box.upper + margin);
  PovObject made =
      pov_implicit([&](Vec3 p) { return in_.value_of(function, p) - threshold; }, wider, cells());
  made.place = at;
  if (open) {
    pov_clip(&made, {container.solid}, cuts_);
    return made;
  }
  std::vector<PovObject> both;
  both.push_back(std::move(made));
  both.push_back(std::move(container));
  return pov_intersection(std::move(both), cuts_);
}

// bicubic_patch { type T flatness F u_steps U v_steps V, 16 points }
PovObject PovSceneReader::patch_shape() {
  while (in_.next_is("type") || in_.next_is("flatness") || in_.next_is("u_steps") || in_.next_is("v_steps") ||
         in_.next_is("accuracy")) {
    in_.take();
    in_.number();
    in_.skip_comma();
  }
  in_.skip_comma();
  std::array<std::array<Vec3, 4>, 4> control{};
  for (auto& row : control)
    for (Vec3& point : row) {
      point = in_.vector();
      in_.skip_comma();
    }
  const int steps = std::max(2, options_.tessellate / 4);
  const auto weights = [steps](int k) {
    const double t = static_cast<double>(k) / steps, u = 1 - t;
    return std::array<double, 4>{u * u * u, 3 * t * u * u, 3 * t * t * u, t * t * t};
  };
  PovObject made;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j) {
      Vec3 sum;
      for (size_t a = 0; a < 4; ++a)
        for (size_t b = 0; b < 4; ++b) sum += weights(i)[a] * weights(j)[b] * control[a][b];
      made.points.push_back(sum);
    }
  const auto at = [steps](int i, int j) { return static_cast<uint32_t>(i * (steps + 1) + j); };
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j)
      for (const std::array<uint32_t, 3> corners : {std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1)},
                                                    std::array{at(i, j), at(i + 1, j + 1), at(i, j + 1)}}) {
        PovFacet facet;
        facet.corners.assign(corners.begin(), corners.end());
        made.facets.push_back(std::move(facet));
      }
  return made;
}

}  // namespace strad
