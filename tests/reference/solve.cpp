#include <algorithm>

#include <Eigen/SparseCholesky>

#include "common/base/check.h"
#include "tests/reference/elimination_order.h"
#include "tests/reference/reference.h"

namespace burnish::reference {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;
using Factors = Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>>;

namespace {

/// A corner is pinned if its diagonal is below this part of the median. Corners of slivers have
/// small diagonals and yet move their vertices: with 1e-12 the answer is off by 8e-5 of the box's
/// diagonal on torn walls; from 1e-15 on it does not depend on the number.
constexpr double kPinRatio = 1e-20;

/// Flat parts parallel to an axis make S singular: a trilinear function can vanish on a plane. So
/// the factorised matrix is shifted a little, in units of the scaled diagonal. Refining against the
/// unshifted matrix removes the shift's bias. More refinements would only let rounding grow along
/// those functions.
constexpr double kFactorShift = 1e-13;
constexpr int kRefinementsMax = 3;

std::vector<int> free_corners(const VectorXd& diagonal) {
  std::vector<double> sorted(diagonal.begin(), diagonal.end());
  std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
  const double least = kPinRatio * sorted[sorted.size() / 2];
  std::vector<int> free;
  for (int i = 0; i < diagonal.size(); ++i)
    if (diagonal[i] > least) free.push_back(i);
  return free;
}

/// Keeps the rows and columns in `free`, scaled so that the diagonal becomes 1.
SparseMatrix scaled_free_part(const SparseMatrix& s, const std::vector<int>& free,
                              const VectorXd& scale) {
  std::vector<int> position(s.rows(), -1);
  for (size_t i = 0; i < free.size(); ++i) position[free[i]] = static_cast<int>(i);
  std::vector<Eigen::Triplet<double>> entries;
  for (int column : free)
    for (SparseMatrix::InnerIterator it(s, column); it; ++it)
      if (position[it.row()] >= 0)
        entries.emplace_back(position[it.row()], position[column],
                             it.value() * scale[it.row()] * scale[column]);
  SparseMatrix part(free.size(), free.size());
  part.setFromTriplets(entries.begin(), entries.end());
  return part;
}

/// Spreads rows of the free corners, scaled, to a row for every corner.
MatrixXd spread(const MatrixXd& x, const std::vector<int>& free, const VectorXd& scale) {
  MatrixXd whole = MatrixXd::Zero(scale.size(), x.cols());
  whole(free, Eigen::all) = scale(free).asDiagonal() * x;
  return whole;
}

}  // namespace

Solution solve(const System& system, const std::vector<CellFields>& fields,
               const MatrixXd& signal) {
  const SparseMatrix s = system_matrix(system, fields);
  const VectorXd diagonal = s.diagonal();
  const std::vector<int> free = elimination_order(system.corners, free_corners(diagonal));
  const VectorXd scale = diagonal.cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const SparseMatrix matrix = scaled_free_part(s, free, scale);
  const MatrixXd b = (scale.asDiagonal() * constraint(system, fields, signal))(free, Eigen::all);
  Factors factors;
  factors.setShift(kFactorShift);
  factors.compute(matrix);
  BURNISH_CHECK(factors.info() == Eigen::Success, "a scaled positive matrix has its factors");

  Solution solution;
  MatrixXd x = factors.solve(b);
  for (int i = 0; i < kRefinementsMax; ++i) {
    const MatrixXd correction = factors.solve(b - matrix * x);
    x += correction;
    solution.last_move = evaluate(system, spread(correction, free, scale)).cwiseAbs().maxCoeff();
  }
  solution.displacement = spread(x, free, scale);
  solution.pinned = static_cast<int>(system.corners.size() - free.size());
  if (b.norm() > 0) solution.residual = (b - matrix * x).norm() / b.norm();
  return solution;
}

std::vector<Vec3d> edited_vertices(const System& system, const std::vector<CellFields>& fields) {
  return displaced_vertices(system, solve(system, fields, corner_positions(system)).displacement);
}

}  // namespace burnish::reference
