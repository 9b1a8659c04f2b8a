#include "import/poses/rigid_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace strad {
namespace {

using Matrix4 = std::array<std::array<double, 4>, 4>;

// Turns the plane of rows and columns p and q so that a[p][q] becomes 0 (Jacobi 1846), and `vectors` with it.
void rotate_out(Matrix4* matrix, Matrix4* vectors, size_t p, size_t q) {
  Matrix4& a = *matrix;
  if (a[p][q] == 0) return;
  const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1), s = t * c;
  for (size_t k = 0; k < 4; ++k) {
    const double x = a[k][p], y = a[k][q];
    a[k][p] = c * x - s * y;
    a[k][q] = s * x + c * y;
  }
  for (size_t k = 0; k < 4; ++k) {
    const double x = a[p][k], y = a[q][k];
    a[p][k] = c * x - s * y;
    a[q][k] = s * x + c * y;
  }
  for (size_t k = 0; k < 4; ++k) {
    const double x = (*vectors)[k][p], y = (*vectors)[k][q];
    (*vectors)[k][p] = c * x - s * y;
    (*vectors)[k][q] = s * x + c * y;
  }
}

// The eigenvector of the largest eigenvalue of a symmetric matrix. Of equal ones the first.
std::array<double, 4> largest_eigenvector(Matrix4 a) {
  Matrix4 vectors{};
  for (size_t i = 0; i < 4; ++i) vectors[i][i] = 1;
  constexpr int kSweeps = 30;  // converges in about six
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    double off = 0, all = 0;
    for (size_t p = 0; p < 4; ++p)
      for (size_t q = 0; q < 4; ++q) {
        all += a[p][q] * a[p][q];
        if (p != q) off += a[p][q] * a[p][q];
      }
    if (!(off > 1e-36 * all)) break;
    for (size_t p = 0; p < 4; ++p)
      for (size_t q = p + 1; q < 4; ++q) rotate_out(&a, &vectors, p, q);
  }
  size_t best = 0;
  for (size_t i = 1; i < 4; ++i)
    if (a[i][i] > a[best][best] * (1 + 1e-12)) best = i;
  return {vectors[0][best], vectors[1][best], vectors[2][best], vectors[3][best]};
}

}  // namespace

void RigidFit::add(std::span<const Vec3> rest, std::span<const Vec3> seen) {
  if (rest.empty()) return;
  if (count_ == 0) origin_rest_ = rest.front(), origin_seen_ = seen.front();
  for (size_t i = 0; i < rest.size(); ++i) {
    const Vec3 p = rest[i] - origin_rest_, q = seen[i] - origin_seen_;
    count_ += 1;
    rest_ += p;
    seen_ += q;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) products_[r][c] += p[r] * q[c];
  }
}

Pose RigidFit::pose() const {
  if (!(count_ > 0)) return {};
  const Vec3 centre_rest = rest_ / count_, centre_seen = seen_ / count_;
  double m[3][3];
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) m[r][c] = products_[r][c] - count_ * centre_rest[r] * centre_seen[c];
  const Matrix4 horn{
      {{m[0][0] + m[1][1] + m[2][2], m[1][2] - m[2][1], m[2][0] - m[0][2], m[0][1] - m[1][0]},
       {m[1][2] - m[2][1], m[0][0] - m[1][1] - m[2][2], m[0][1] + m[1][0], m[2][0] + m[0][2]},
       {m[2][0] - m[0][2], m[0][1] + m[1][0], m[1][1] - m[0][0] - m[2][2], m[1][2] + m[2][1]},
       {m[0][1] - m[1][0], m[2][0] + m[0][2], m[1][2] + m[2][1], m[2][2] - m[0][0] - m[1][1]}}};
  const auto v = largest_eigenvector(horn);
  const double norm = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3]);
  const double sign = v[0] < 0 ? -1 / norm : 1 / norm;
  const Quat turn{sign * v[0], sign * v[1], sign * v[2], sign * v[3]};
  return {turn, origin_seen_ + centre_seen - rotate(turn, origin_rest_ + centre_rest)};
}

Pose fit_rigid(std::span<const Vec3> rest, std::span<const Vec3> seen) {
  RigidFit fit;
  fit.add(rest, seen);
  return fit.pose();
}

double fit_error(const Pose& pose, std::span<const Vec3> rest, std::span<const Vec3> seen) {
  double worst = 0;
  for (size_t i = 0; i < rest.size(); ++i) worst = std::max(worst, length2(pose * rest[i] - seen[i]));
  return std::sqrt(worst);
}

}  // namespace strad
