#include "server/prepare/cell_moments.h"

#include "server/prepare/quadrature.h"

namespace burnish {

static constexpr int kStride[3] = {1, 3, 9};

// Does m += weight times the area times the 27 products at one point of each triangle.
[[gnu::always_inline]] static inline void add_point(const TriangleBatch& t,
                                                    const QuadraturePoint& q, Double8 (&m)[27]) {
  Double8 beta[3][3];
  for (int axis = 0; axis < 3; ++axis) {
    const Double8 high =
        q.a * t.corner[0][axis] + q.b * t.corner[1][axis] + q.c * t.corner[2][axis];
    const Double8 low = 1 - high;
    beta[axis][0] = low * low;
    beta[axis][1] = low * high;
    beta[axis][2] = high * high;
  }
  const Double8 weight = q.weight * t.area;
  for (Double8& of_x : beta[0]) of_x *= weight;
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k)
#pragma GCC unroll 3
    for (int j = 0; j < 3; ++j) {
      const Double8 yz = beta[1][j] * beta[2][k];
#pragma GCC unroll 3
      for (int i = 0; i < 3; ++i) m[i + 3 * j + 9 * k] += beta[0][i] * yz;
    }
}

// Adds the moments of one axis r, made from those of products: ∂_r of a basis function is ±1 along
// r.
[[gnu::always_inline]] static inline void add_axis(const TriangleBatch& t, const Double8 (&m)[27],
                                                   int r, CellMoments<Double8>& sums) {
  const int s = kStride[kBeside[r][0]], v = kStride[kBeside[r][1]], along = kStride[r];
  Double8 product[9];
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j) {
      const Double8* line = m + j * s + k * v;
      product[j + 3 * k] = line[0] + 2 * line[along] + line[2 * along];
    }
  for (int table = 0; table < 2; ++table) {
    // The two directions and the normal are orthonormal: n nᵀ = 1 − v₁v₁ᵀ − v₂v₂ᵀ.
    const Double8 across = 1 - t.tensor[0][r] - t.tensor[1][r];
    const Double8 stiffness = t.tensor[table][r] + 0.5 * kNormalStiffness * across;
    for (int i = 0; i < 9; ++i) sums.along[table][r][i] += stiffness * product[i];
  }
}

// Adds the moments of the two axes beside t.
[[gnu::always_inline]] static inline void add_pair(const TriangleBatch& triangles,
                                                   const Double8 (&m)[27], int t,
                                                   CellMoments<Double8>& sums) {
  const int r = kStride[kBeside[t][0]], s = kStride[kBeside[t][1]];
  Double8 stiffness[2];
  for (int table = 0; table < 2; ++table)
    stiffness[table] =
        triangles.tensor[table][3 + t] -
        0.5 * kNormalStiffness * (triangles.tensor[0][3 + t] + triangles.tensor[1][3 + t]);
  for (int u = 0; u < 2; ++u)
    for (int v = 0; v < 2; ++v)
      for (int k = 0; k < 3; ++k) {
        const Double8* square = m + u * r + v * s + k * kStride[t];
        const Double8 product = (square[0] + square[r]) + (square[s] + square[r + s]);
        for (int table = 0; table < 2; ++table)
          sums.across[table][t][u][v][k] += stiffness[table] * product;
      }
}

BURNISH_DISPATCH void add_moments(const TriangleBatch& triangles, CellMoments<Double8>& sums) {
  Double8 m[27] = {};
  for (const QuadraturePoint& q : kDegree6Rule) add_point(triangles, q, m);
  for (int i = 0; i < 27; ++i) sums.mass[i] += m[i];
#pragma GCC unroll 3
  for (int axis = 0; axis < 3; ++axis) {
    add_axis(triangles, m, axis, sums);
    add_pair(triangles, m, axis, sums);
  }
}

// Makes the sums over the lanes of eight vectors.
[[gnu::always_inline]] static inline void sum_eight(const Double8* of, double* sums) {
  Double8 pairs[4], fours[2];
  for (int i = 0; i < 4; ++i)
    pairs[i] = __builtin_shufflevector(of[2 * i], of[2 * i + 1], 0, 8, 2, 10, 4, 12, 6, 14) +
               __builtin_shufflevector(of[2 * i], of[2 * i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  for (int i = 0; i < 2; ++i)
    fours[i] = __builtin_shufflevector(pairs[2 * i], pairs[2 * i + 1], 0, 1, 8, 9, 4, 5, 12, 13) +
               __builtin_shufflevector(pairs[2 * i], pairs[2 * i + 1], 2, 3, 10, 11, 6, 7, 14, 15);
  const Double8 eight = __builtin_shufflevector(fours[0], fours[1], 0, 1, 2, 3, 8, 9, 10, 11) +
                        __builtin_shufflevector(fours[0], fours[1], 4, 5, 6, 7, 12, 13, 14, 15);
  __builtin_memcpy(sums, &eight, sizeof eight);
}

BURNISH_DISPATCH static void sum_lanes(const Double8* of, int count, double* sums) {
  for (int i = 0; i + 8 <= count; i += 8) sum_eight(of + i, sums + i);
  Double8 rest[8] = {};
  double last[8];
  for (int i = 0; i < count % 8; ++i) rest[i] = of[count / 8 * 8 + i];
  sum_eight(rest, last);
  for (int i = 0; i < count % 8; ++i) sums[count / 8 * 8 + i] = last[i];
}

CellMoments<double> sum_of_lanes(const CellMoments<Double8>& sums) {
  CellMoments<double> total;
  sum_lanes(reinterpret_cast<const Double8*>(&sums), sizeof total / sizeof(double),
            reinterpret_cast<double*>(&total));
  return total;
}

}  // namespace burnish
