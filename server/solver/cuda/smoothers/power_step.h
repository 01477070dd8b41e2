#pragma once

#include "server/solver/cuda/device/reduce.h"
#include "server/solver/cuda/smoothers/spectrum.h"
#include "server/solver/cycle/schwarz_bounds.h"

// The part of a kernel for M⁻¹ that makes it a power iteration.

namespace burnish::cuda {

/// Replaces x_i by (M⁻¹S x)_i and adds to the thread's sums.
__device__ inline void replace(const PowerStep& power, int32_t i, float4 next, float4 product,
                               float normalise, Sums<2>& sums) {
  if (i < power.own_count) {
    sums.at[0] += sum_of(to_double(power.x[i]) * to_double(product));
    sums.at[1] += sum_of(to_double(next) * to_double(product));
  }
  power.x[i] = normalise * next;
}

__device__ inline void set_steps(float lambda_max, Spectrum& spectrum) {
  const float centre = lambda_max * (1 + 1 / kSchwarzRange) / 2;
  const float half_width = lambda_max * (1 - 1 / kSchwarzRange) / 2;
  const float sigma = centre / half_width;
  const float rho = 1 / (2 * sigma - 1 / sigma);
  spectrum.first_step = 1 / centre;
  spectrum.momentum = rho / sigma;
  spectrum.second_step = 2 * rho / half_width;
}

/// Makes the steps from the present estimate.
__device__ inline void renew_steps(float anisotropy, Spectrum& spectrum) {
  const float estimate = static_cast<float>(kLambdaMaxMargin) * spectrum.lambda_max;
  set_steps(fminf(fmaxf(estimate, lambda_max_least(anisotropy)), kLambdaMaxBound), spectrum);
}

/// Makes the steps from the sums over all corners.
__device__ inline void finish_spectrum(const PowerStep& power, const Sums<2>& total) {
  Spectrum& spectrum = *power.spectrum;
  if (total.at[0] > 0 && total.at[1] > 0) {
    spectrum.lambda_max = static_cast<float>(total.at[1] / total.at[0]);
    spectrum.normalise = static_cast<float>(1 / sqrt(total.at[1]));
  }
  renew_steps(*power.anisotropy, spectrum);
}

/// Every thread of every block calls it with its sums. The last block makes the steps from them.
__device__ inline void update_spectrum(const PowerStep& power, const Sums<2>& sums) {
  Sums<2> total;
  if (!add_up(sums, power.partials, &total)) return;
  if (power.totals != nullptr)
    tell(total, power.totals);
  else
    finish_spectrum(power, total);
}

}  // namespace burnish::cuda
