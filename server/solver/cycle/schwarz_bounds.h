#pragma once

#include <cmath>

namespace burnish {

// What every backend's additive Schwarz smoother knows of the spectrum of M⁻¹S.
//
// λmax is found by power iteration, from below. It starts from the last metric's eigenvector and
// may take long to leave it when another becomes the largest elsewhere. An under-estimate ruins the
// cycle and an over-estimate by a third costs nothing: hence a margin, and a least value above what
// was seen on scans: 11 where α1 = α2, 14 at a ratio of 100, 21 at 1000 at the most. No more than
// 27 blocks meet (three cells an axis), which is the bound, but where sheets apart share a corner;
// there no more than 18 was seen.

inline constexpr double kLambdaMaxMargin = 1.15;
inline constexpr double kLambdaMaxBound = 27;

/// `anisotropy`: the largest ratio of α1 and α2, either way round, of any cell.
#ifdef __CUDACC__
__host__ __device__
#endif
    inline float
    lambda_max_least(float anisotropy) {
  return 12.5f * powf(anisotropy, 0.07f);
}

/// The Chebyshev iteration of degree 2 damps the eigenvalues in [λmax / kSchwarzRange, λmax].
inline constexpr float kSchwarzRange = 20;

}  // namespace burnish
