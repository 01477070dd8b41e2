#pragma once

#include <array>
#include <cstdint>

#include "common/base/types.h"

namespace burnish {

// A direction as two integers: it is stretched onto the octahedron |x| + |y| + |z| = 1. The half
// below, z < 0, is folded outwards, so that the octahedron becomes the square -1 <= u, v <= 1. A
// code (u, v) means (u, v) / limit. So the axes are exact. With the limit of pages, others are off
// by a third of a degree on average, by 0.94 at most.

inline constexpr int kOctahedralLimit = 127;  // of the normals of pages

using OctahedralCode = std::array<int, 2>;

/// Rounds to the nearest code. Needs: a finite vector that is not zero; a limit below 2^20.
OctahedralCode octahedral_code(const Vec3f& direction, int limit = kOctahedralLimit);

/// Returns a unit vector, for any code of |u|, |v| <= limit + 1.
Vec3f octahedral_normal(const OctahedralCode& code, int limit = kOctahedralLimit);

/// A sum of the cross products of a vertex's triangles, in steps of PageGrid.
using NormalSum = std::array<int64_t, 3>;

/// Returns a code near the direction of a sum in integers alone, so that all programs return the
/// same. First the sum is shifted down until |x| + |y| + |z| is below 2^21. Divisions cut off.
/// Returns (0, 0) for a sum of zero. Needs: |x| + |y| + |z| < 2^63.
OctahedralCode predicted_code(const NormalSum& sum);

}  // namespace burnish
