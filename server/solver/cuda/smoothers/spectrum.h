#pragma once

#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// The present estimate of λmax of M⁻¹S from power iteration, three columns at once, and the steps
/// of the Chebyshev iteration that follow from it.
struct Spectrum {
  float lambda_max;
  float normalise;  ///< keeps the vector near one
  float first_step, momentum, second_step;
};

/// A power iteration's vector x and product S x, and the place of its sums.
struct PowerStep {
  float4* x;
  const float4* product;
  const float* anisotropy;  ///< the largest ratio of α1 to α2, or α2 to α1, in any cell
  Spectrum* spectrum;
  Partials<2> partials;  ///< x·Sx and M⁻¹Sx·Sx
  int32_t own_count;     ///< the sums are over the first corners
  double* totals;        ///< for the other shards, which make the steps together; or null
};

}  // namespace burnish::cuda
