#pragma once

#include <cstdint>

#include "common/base/types.h"

namespace burnish {

// Randomness for generated scans. Only integers, + - * / and sqrt: the same bits on every machine,
// which the distributions of <random> and the functions of libm do not promise.

/// Well-mixed bits of x (the finaliser of SplitMix64, Steele et al. 2014).
constexpr uint64_t mix(uint64_t x) {
  x += 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

/// An independent seed for each use that one generator makes of its seed.
constexpr uint64_t sub_seed(uint64_t seed, uint64_t use) {
  return mix(mix(seed) ^ use);
}

/// Uniform in [0, 1), the index-th draw of this seed.
constexpr double uniform(uint64_t seed, uint64_t index) {
  return static_cast<double>(mix(seed ^ mix(index)) >> 11) * 0x1p-53;
}

/// Nearly normal with mean 0 and deviation 1: four uniforms summed, so never beyond 3.5.
double bounded_normal(uint64_t seed, uint64_t index);

/// Smooth noise with features about one unit wide: 0 at lattice points, mean 0, deviation near
/// 0.25, within [-1, 1] but for rare peaks.
double gradient_noise(const Vec3d& p, uint64_t seed);

/// Octaves of gradient noise, each at half the amplitude and twice the frequency of the last.
double fractal_noise(const Vec3d& p, int octaves, uint64_t seed);

}  // namespace burnish
