#include "import/pov/language/noise.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"

namespace strad {
namespace {

constexpr uint64_t kSeed = 76;  // of POV-Ray's internal function f_noise3d

// The slope of the noise at a corner of the lattice, times the way from there: one of the 12 directions to
// the middles of a cube's edges (Perlin 2002).
double slope(int64_t x, int64_t y, int64_t z, Vec3 way) {
  const uint64_t column = hash_of(kSeed + static_cast<uint64_t>(x), static_cast<uint64_t>(y));
  const uint64_t hash = hash_of(column, static_cast<uint64_t>(z)) >> 32;
  const uint64_t zero_axis = hash % 3;
  const double u = zero_axis == 0 ? way.y : way.x, v = zero_axis == 2 ? way.y : way.z;
  return (hash & 8 ? u : -u) + (hash & 16 ? v : -v);
}

double faded(double t) { return t * t * t * (t * (6 * t - 15) + 10); }
double mixed(double a, double b, double t) { return a + t * (b - a); }

}  // namespace

double noise_at(Vec3 p) {
  constexpr double kFar = 1e15;  // beyond, cells are smaller than what doubles tell apart
  if (!(std::abs(p.x) < kFar && std::abs(p.y) < kFar && std::abs(p.z) < kFar)) return 0.5;
  const Vec3 cell{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  const auto x = static_cast<int64_t>(cell.x), y = static_cast<int64_t>(cell.y),
             z = static_cast<int64_t>(cell.z);
  const Vec3 way = p - cell;
  const auto row = [&](int dy, int dz) {
    const double from = slope(x, y + dy, z + dz, way - Vec3{0, double(dy), double(dz)});
    const double to = slope(x + 1, y + dy, z + dz, way - Vec3{1, double(dy), double(dz)});
    return mixed(from, to, faded(way.x));
  };
  const double ty = faded(way.y), tz = faded(way.z);
  const double value = mixed(mixed(row(0, 0), row(1, 0), ty), mixed(row(0, 1), row(1, 1), ty), tz);
  return std::clamp(0.5 + 0.5 * value, 0.0, 1.0);
}

Vec3 turbulence_at(Vec3 p, double lambda, double omega, int octaves) {
  Vec3 sum;
  double size = 1;
  constexpr int kMost = 10;  // as in POV-Ray
  // Three noises far from each other, in the range of POV-Ray's own.
  for (int octave = 0; octave < std::min(octaves, kMost); ++octave, p = lambda * p, size *= omega)
    sum +=
        2 * size *
        Vec3{noise_at(p) - 0.5, noise_at(p + Vec3{1000, 0, 0}) - 0.5, noise_at(p + Vec3{0, 0, 1000}) - 0.5};
  return sum;
}

}  // namespace strad
