#include "server/prepare/cell_integrals.h"

#include "common/base/dispatch.h"

namespace burnish {

static std::array<double, 6> tensor_of(const Vec3d& v) {
  return {v[0] * v[0], v[1] * v[1], v[2] * v[2], v[1] * v[2], v[0] * v[2], v[0] * v[1]};
}

void CellIntegrator::add(const Polygon& piece, const Vec3d& v1, const Vec3d& v2, bool umbilic) {
  std::array<Tensor, 2> tensors = {tensor_of(v1), tensor_of(v2)};
  if (umbilic)
    for (int i = 0; i < 6; ++i) tensors[0][i] = tensors[1][i] = (tensors[0][i] + tensors[1][i]) / 2;
  for (int i = 2; i < piece.count; ++i)
    add_triangle({piece.vertices[0], piece.vertices[i - 1], piece.vertices[i]}, tensors);
}

void CellIntegrator::add_triangle(const std::array<Vec3d, 3>& corners,
                                  const std::array<Tensor, 2>& tensors) {
  const double area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm() / 2;
  if (!(area > kPieceAreaMin)) return;
  area_ += area;
  const int lane = waiting_++;
  batch_.area[lane] = area;
  for (int corner = 0; corner < 3; ++corner)
    for (int axis = 0; axis < 3; ++axis) batch_.corner[corner][axis][lane] = corners[corner][axis];
  for (int table = 0; table < 2; ++table)
    for (int i = 0; i < 6; ++i) batch_.tensor[table][i][lane] = tensors[table][i];
  if (waiting_ == TriangleBatch::kLanes) flush();
}

void CellIntegrator::flush() {
  for (int lane = waiting_; lane < TriangleBatch::kLanes; ++lane) batch_.area[lane] = 0;
  add_moments(batch_, moments_);
  waiting_ = 0;
}

// Returns ±1: the slope of h₀ or h₁.
static constexpr double sign(int high) {
  return high != 0 ? 1 : -1;
}

// Returns ∫ S ∇B_a · ∇B_b of one table.
[[gnu::always_inline]] static inline double stiffness_of(const double (&along)[3][9],
                                                         const double (&across)[3][2][2][3],
                                                         const int (&a)[3], const int (&b)[3]) {
  double sum = 0;
#pragma GCC unroll 3
  for (int r = 0; r < 3; ++r) {
    const int s = kBeside[r][0], t = kBeside[r][1];
    sum += sign(a[r]) * sign(b[r]) * along[r][(a[s] + b[s]) + 3 * (a[t] + b[t])];
  }
#pragma GCC unroll 3
  for (int t = 0; t < 3; ++t) {
    const int r = kBeside[t][0], s = kBeside[t][1];
    sum += sign(a[r]) * sign(b[s]) * across[t][b[r]][a[s]][a[t] + b[t]] +
           sign(b[r]) * sign(a[s]) * across[t][a[r]][b[s]][a[t] + b[t]];
  }
  return sum;
}

BURNISH_DISPATCH static void expand(const CellMoments<double>& moments, CellIntegrals& out) {
#pragma GCC unroll 8
  for (int i = 0; i < 8; ++i) {
    const int a[3] = {i & 1, i >> 1 & 1, i >> 2};
    const double* m = moments.mass + a[0] + 3 * a[1] + 9 * a[2];
    out.mass_row_sum[i] = ((m[0] + m[1]) + (m[3] + m[4])) + ((m[9] + m[10]) + (m[12] + m[13]));
#pragma GCC unroll 8
    for (int j = i + 1; j < 8; ++j) {
      const int b[3] = {j & 1, j >> 1 & 1, j >> 2};
      const int pair = i * 7 - i * (i - 1) / 2 + (j - i - 1);
      out.mass[pair] = m[b[0] + 3 * b[1] + 9 * b[2]];
      for (int table = 0; table < 2; ++table)
        out.stiffness[table][pair] =
            stiffness_of(moments.along[table], moments.across[table], a, b);
    }
  }
}

// Adds the part of the cell as a solid to ∫ β_j β_k along each axis, half of it to each table.
static void add_cell_stiffness(double area, CellMoments<double>& moments) {
  constexpr double kWhole[3] = {1.0 / 3, 1.0 / 6, 1.0 / 3};  // ∫ β over [0, 1]
  for (auto& of_table : moments.along)
    for (auto& of_axis : of_table)
      for (int i = 0; i < 9; ++i)
        of_axis[i] += 0.5 * kCellStiffness * area * kWhole[i % 3] * kWhole[i / 3];
}

CellIntegrals CellIntegrator::integrals() {
  if (waiting_ > 0) flush();
  CellMoments<double> moments = sum_of_lanes(moments_);
  add_cell_stiffness(area_, moments);
  CellIntegrals out;
  expand(moments, out);
  return out;
}

}  // namespace burnish
