#pragma once

#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// λmax of M⁻¹S as found so far by power iteration, three columns at once, and the steps of the
/// Chebyshev iteration that follow from it.
struct Spectrum {
  float lambda_max;
  float normalise;  ///< keeps the vector near one
  float first_step, momentum, second_step;
};

/// A power iteration's vector x and product S x, and where its sums go.
struct PowerStep {
  float4* x;
  const float4* product;
  const float* anisotropy;  ///< the largest ratio of α1 and α2 of any cell
  Spectrum* spectrum;
  Partials<2> partials;  ///< x·Sx and M⁻¹Sx·Sx
};

}  // namespace burnish::cuda
