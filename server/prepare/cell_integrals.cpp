#include "server/prepare/cell_integrals.h"

#include "common/base/dispatch.h"
#include "common/grid/sparse_grid.h"
#include "server/prepare/quadrature.h"

namespace burnish {

using Square = CellIntegrator::Square;
using Eight = std::array<double, 8>;

// share[i][j]: how much of direction j goes to table i.
using Share = std::array<std::array<double, 2>, 2>;
static constexpr Share kShareOwn = {{{1, 0}, {0, 1}}};
static constexpr Share kShareBoth = {{{0.5, 0.5}, {0.5, 0.5}}};

// Trilinear weights, or their derivative along one axis where `derivative` >= 0, of all corners.
static inline Eight trilinear(const double (&p)[3], int derivative) {
  double low[3], high[3];
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = axis == derivative ? -1.0 : 1.0 - p[axis];
    high[axis] = axis == derivative ? 1.0 : p[axis];
  }
  Eight weights;
  for (int a = 0; a < 8; ++a)
    weights[a] =
        (a & 1 ? high[0] : low[0]) * (a & 2 ? high[1] : low[1]) * (a & 4 ? high[2] : low[2]);
  return weights;
}

static inline void add_outer_product(Square& sum, const Eight& x, double weight) {
  for (int a = 0; a < 8; ++a) {
    const double wa = weight * x[a];
    for (int b = 0; b < 8; ++b) sum[a][b] += wa * x[b];
  }
}

static inline void point_at(const QuadraturePoint& q, const Vec3d (&corner)[3], double (&p)[3]) {
  for (int axis = 0; axis < 3; ++axis)
    p[axis] = q.a * corner[0][axis] + q.b * corner[1][axis] + q.c * corner[2][axis];
}

BURNISH_DISPATCH
static void integrate_mass(const Vec3d (&corner)[3], double area, Square& mass, Eight& row_sum) {
  double p[3];
  for (const QuadraturePoint& q : kDegree6Rule) {
    point_at(q, corner, p);
    const Eight b = trilinear(p, -1);
    const double weight = area * q.weight;
    add_outer_product(mass, b, weight);
    for (int a = 0; a < 8; ++a) row_sum[a] += weight * b[a];
  }
}

BURNISH_DISPATCH
static void integrate_stiffness(const Vec3d (&corner)[3], double area, const Vec3d (&v)[3],
                                const Share& share, std::array<Square, 2>& stiffness,
                                std::array<Eight, 2>& slope) {
  double p[3];
  for (const QuadraturePoint& q : kDegree4Rule) {
    point_at(q, corner, p);
    const Eight dx = trilinear(p, 0), dy = trilinear(p, 1), dz = trilinear(p, 2);
    const double weight = area * q.weight;
    for (int i = 0; i < 2; ++i) {
      Eight along;
      for (int a = 0; a < 8; ++a) along[a] = v[i][0] * dx[a] + v[i][1] * dy[a] + v[i][2] * dz[a];
      for (int j = 0; j < 2; ++j)
        if (share[j][i] != 0) add_outer_product(stiffness[j], along, share[j][i] * weight);
      for (int a = 0; a < 8; ++a) slope[i][a] += weight * along[a];
    }
    Eight across;
    for (int a = 0; a < 8; ++a) across[a] = v[2][0] * dx[a] + v[2][1] * dy[a] + v[2][2] * dz[a];
    for (int i = 0; i < 2; ++i)
      add_outer_product(stiffness[i], across, 0.5 * kNormalStiffness * weight);
  }
}

std::array<std::array<Vec3d, 8>, 2> CellIntegrator::zero_gradient() {
  std::array<std::array<Vec3d, 8>, 2> zero;
  for (auto& of_direction : zero) of_direction.fill(Vec3d::Zero());
  return zero;
}

void CellIntegrator::add(const Polygon& piece, const Vec3d& v1, const Vec3d& v2, bool umbilic) {
  for (int i = 2; i < piece.count; ++i)
    add_triangle(piece.vertices[0], piece.vertices[i - 1], piece.vertices[i], v1, v2, umbilic);
}

void CellIntegrator::add_triangle(const Vec3d& p, const Vec3d& q, const Vec3d& r, const Vec3d& v1,
                                  const Vec3d& v2, bool umbilic) {
  const double area = (q - p).cross(r - p).norm() / 2;
  if (!(area > kPieceAreaMin)) return;
  const Vec3d corner[3] = {p, q, r};
  const Vec3d v[3] = {v1, v2, v1.cross(v2)};
  std::array<Eight, 2> slope = {};
  integrate_mass(corner, area, mass_, mass_row_sum_);
  const Share& share = umbilic ? kShareBoth : kShareOwn;
  integrate_stiffness(corner, area, v, share, stiffness_, slope);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int a = 0; a < 8; ++a) gradient_[i][a] += share[i][j] * slope[j][a] * v[j];
  area_ += area;
}

static std::array<double, 28> off_diagonal(const Square& matrix) {
  std::array<double, 28> packed;
  int pair = 0;
  for (int a = 0; a < 8; ++a)
    for (int b = a + 1; b < 8; ++b) packed[pair++] = matrix[a][b];
  return packed;
}

CellIntegrals CellIntegrator::integrals() const {
  CellIntegrals out;
  out.mass = off_diagonal(mass_);
  out.mass_row_sum = mass_row_sum_;
  for (int i = 0; i < 2; ++i) {
    out.stiffness[i] = off_diagonal(stiffness_[i]);
    for (int a = 0; a < 7; ++a)
      for (int axis = 0; axis < 3; ++axis) out.gradient[i][3 * a + axis] = gradient_[i][a][axis];
  }
  return out;
}

}  // namespace burnish
