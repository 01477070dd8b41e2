#pragma once

#include <cstdint>

#include "common/base/types.h"

namespace burnish {

// Randomness for generated scans. Uses only integers, + - * / and sqrt, which give the same bits on
// every machine. The distributions of <random> and the functions of libm do not promise that.

/// Well-mixed bits of x (the finaliser of SplitMix64, Steele et al. 2014).
constexpr uint64_t mix(uint64_t x) {
  x += 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

/// Returns an independent seed for each use of one generator's seed.
constexpr uint64_t sub_seed(uint64_t seed, uint64_t use) {
  return mix(mix(seed) ^ use);
}

/// Returns the index-th draw of this seed, uniform in [0, 1).
constexpr double uniform(uint64_t seed, uint64_t index) {
  return static_cast<double>(mix(seed ^ mix(index)) >> 11) * 0x1p-53;
}

/// Returns a nearly normal number with mean 0 and deviation 1: a sum of four uniforms, so never
/// beyond 3.5.
double bounded_normal(uint64_t seed, uint64_t index);

/// Returns smooth noise with features about one unit wide: 0 at lattice points, mean 0, deviation
/// near 0.25, within [-1, 1] except for rare peaks.
double gradient_noise(const Vec3d& p, uint64_t seed);

/// Sums octaves of gradient noise, each with half the amplitude and twice the frequency of the
/// last.
double fractal_noise(const Vec3d& p, int octaves, uint64_t seed);

}  // namespace burnish
