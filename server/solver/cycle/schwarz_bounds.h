#pragma once

#include <cmath>

namespace burnish {

// Bounds of the spectrum of M⁻¹S for every backend's additive Schwarz smoother.
//
// Power iteration finds λmax from below. It starts from the last metric's eigenvector. It may take
// long to leave it when another eigenvector becomes the largest elsewhere. An estimate that is too
// small ruins the cycle, and one that is a third too large costs nothing. Hence a margin, and a
// least value above all values seen on scans: 11 for α1 = α2, 14 at a ratio of 100, at most 21 at
// 1000. At most 27 blocks meet (three cells per axis), which is the bound. The exception are sheets
// that share a corner; at most 18 was seen there.

inline constexpr double kLambdaMaxMargin = 1.15;
inline constexpr double kLambdaMaxBound = 27;

/// `anisotropy`: the largest ratio of α1 to α2, or of α2 to α1, in any cell.
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
