#include "common/generate/noise.h"

#include <array>
#include <cmath>

namespace burnish {

double bounded_normal(uint64_t seed, uint64_t index) {
  const uint64_t bits = mix(seed ^ mix(index));
  double sum = 0;
  for (int shift = 0; shift < 64; shift += 16) sum += static_cast<double>((bits >> shift) & 0xffff);
  constexpr double kMean = 2 * 65535.0;
  constexpr double kInverseDeviation = 1.7320508075688772 / 65536;  // variance of the sum: 4 / 12
  return (sum - kMean) * kInverseDeviation;
}

/// Returns the ramp of lattice point (x, y, z) at `offset` from it.
static double ramp(int64_t x, int64_t y, int64_t z, const Vec3d& offset, uint64_t seed) {
  const uint64_t bits = mix(seed ^ (static_cast<uint64_t>(x) * 0xd6e8feb86659fd93 +
                                    static_cast<uint64_t>(y) * 0xa0761d6478bd642f +
                                    static_cast<uint64_t>(z) * 0xe7037ed1a0b428db));
  const auto slope = [bits](int shift) {
    return static_cast<double>((bits >> shift) & 0x1fffff) * 0x1p-20 - 1;
  };
  return slope(0) * offset.x() + slope(21) * offset.y() + slope(42) * offset.z();
}

static double fade(double t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}
static double blend(double a, double b, double t) {
  return a + (b - a) * t;
}

double gradient_noise(const Vec3d& p, uint64_t seed) {
  const Vec3d floor(std::floor(p.x()), std::floor(p.y()), std::floor(p.z()));
  const Vec3d t = p - floor;
  const auto x = static_cast<int64_t>(floor.x());
  const auto y = static_cast<int64_t>(floor.y());
  const auto z = static_cast<int64_t>(floor.z());
  const double u = fade(t.x()), v = fade(t.y()), w = fade(t.z());
  const auto layer = [&](int dz) {
    std::array<double, 4> corners;
    for (int i = 0; i < 4; ++i) {
      const int dx = i & 1, dy = i >> 1;
      corners[i] = ramp(x + dx, y + dy, z + dz, t - Vec3d(dx, dy, dz), seed);
    }
    return blend(blend(corners[0], corners[1], u), blend(corners[2], corners[3], u), v);
  };
  return w == 0 ? layer(0) : blend(layer(0), layer(1), w);  // w is 0 on all of a flat face
}

double fractal_noise(const Vec3d& p, int octaves, uint64_t seed) {
  double sum = 0, amplitude = 1, frequency = 1;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += amplitude * gradient_noise(p * frequency, sub_seed(seed, octave));
    amplitude *= 0.5;
    frequency *= 2;
  }
  return sum;
}

}  // namespace burnish
