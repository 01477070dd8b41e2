#pragma once

// The numbers that processors and devices share. nvcc reads this header, so it includes none of the
// others.

namespace burnish {

/// Weights fall no further, so that products of a few stay clear of the slow numbers near 0.
inline constexpr float kExponentMin = -40;

inline constexpr float kNoDirection = 1e-30f;   ///< of a mean normal's squared length
inline constexpr float kGuideSharpness = 5;     ///< 1/τ of unevenness; below 2 edges melt
inline constexpr float kPlaceAreaMin = 1e-30f;  ///< of the mean one: a place of less stays
inline constexpr int kGuardRounds = 4;          ///< corners that stay may turn other triangles

}  // namespace burnish
