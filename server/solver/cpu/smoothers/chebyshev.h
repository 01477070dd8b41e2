#pragma once

#include <array>

namespace burnish::cpu {

/// One step of the Chebyshev iteration: d = momentum·d + length·M⁻¹(f − S x), x += d.
struct ChebyshevStep {
  float momentum = 0;
  float length = 0;
};

/// Returns the steps that best damp the eigenvalues of M⁻¹S in [λmax / `range`, λmax]. The first
/// step has no momentum.
template <int kDegree>
std::array<ChebyshevStep, kDegree> chebyshev_steps(float lambda_max, float range) {
  const float centre = lambda_max * (1 + 1 / range) / 2;
  const float half_width = lambda_max * (1 - 1 / range) / 2;
  const float sigma = centre / half_width;
  std::array<ChebyshevStep, kDegree> steps;
  steps[0] = {0, 1 / centre};
  float rho = 1 / sigma;
  for (int k = 1; k < kDegree; ++k) {
    const float next = 1 / (2 * sigma - rho);
    steps[k] = {next * rho, 2 * next / half_width};
    rho = next;
  }
  return steps;
}

}  // namespace burnish::cpu
