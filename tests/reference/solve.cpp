#include <algorithm>
#include <cmath>

#include <Eigen/SparseCholesky>

#include "common/base/check.h"
#include "tests/reference/elimination_order.h"
#include "tests/reference/reference.h"

namespace burnish::reference {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

std::vector<CellFields> fields(const System& system, const TransferCurve& curve,
                               const GradientScale& beta) {
  std::vector<CellFields> result;
  for (const Cell& cell : system.cells)
    result.push_back(
        {curve.alpha(cell.kappa1), curve.alpha(cell.kappa2), beta(system.cell_centre(cell))});
  return result;
}

std::vector<CellFields> fields(const System& system, const TransferCurve& curve, double beta) {
  return fields(system, curve, [beta](const Vec3d&) { return beta; });
}

namespace {

/// (a2/a1) ell1 + (a1/a2) ell2: ratios, so user units serve as well as grid units.
Matrix8d stiffness(const Cell& cell, const CellFields& f) {
  return f.alpha2 / f.alpha1 * cell.ell1 + f.alpha1 / f.alpha2 * cell.ell2;
}

/// A corner is pinned when its diagonal is below this part of the median.
constexpr double kPinRatio = 1e-12;

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

double largest_move(const System& system, const MatrixXd& displacement) {
  return evaluate(system, displacement).cwiseAbs().maxCoeff();
}

}  // namespace

SparseMatrix system_matrix(const System& system, const std::vector<CellFields>& fields) {
  BURNISH_CHECK(fields.size() == system.cells.size(), "one set of fields per cell");
  const double to_grid = system.cell_size / system.length_unit;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(64 * system.cells.size());
  for (size_t c = 0; c < system.cells.size(); ++c) {
    const Cell& cell = system.cells[c];
    const double mass = fields[c].alpha1 * fields[c].alpha2 * to_grid * to_grid;
    const Matrix8d s = mass * cell.rho + stiffness(cell, fields[c]);
    for (int a = 0; a < 8; ++a)
      for (int b = 0; b < 8; ++b) entries.emplace_back(cell.corners[a], cell.corners[b], s(a, b));
  }
  SparseMatrix matrix(system.corners.size(), system.corners.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

MatrixXd constraint(const System& system, const std::vector<CellFields>& fields,
                    const MatrixXd& signal) {
  MatrixXd b = MatrixXd::Zero(signal.rows(), signal.cols());
  for (size_t c = 0; c < system.cells.size(); ++c) {
    const Cell& cell = system.cells[c];
    // The stiffness annihilates constants: values relative to one corner keep all digits.
    MatrixXd local(8, signal.cols());
    for (int a = 0; a < 8; ++a)
      local.row(a) = signal.row(cell.corners[a]) - signal.row(cell.corners[0]);
    const MatrixXd sums = (fields[c].beta - 1) * (stiffness(cell, fields[c]) * local);
    for (int a = 0; a < 8; ++a) b.row(cell.corners[a]) += sums.row(a);
  }
  return b;
}

MatrixXd corner_positions(const System& system) {
  MatrixXd positions(system.corners.size(), 3);
  for (size_t i = 0; i < system.corners.size(); ++i)
    positions.row(i) << system.corners[i][0], system.corners[i][1], system.corners[i][2];
  return positions;
}

MatrixXd evaluate(const System& system, const MatrixXd& coefficients) {
  MatrixXd values = MatrixXd::Zero(system.evaluation.size(), coefficients.cols());
  for (size_t v = 0; v < system.evaluation.size(); ++v) {
    const EvaluationRow& row = system.evaluation[v];
    if (row.cell < 0) continue;
    for (int a = 0; a < 8; ++a)
      values.row(v) += row.weights[a] * coefficients.row(system.cells[row.cell].corners[a]);
  }
  return values;
}

Solution solve(const System& system, const std::vector<CellFields>& fields,
               const MatrixXd& signal) {
  const SparseMatrix s = system_matrix(system, fields);
  const VectorXd diagonal = s.diagonal();
  const std::vector<int> free = elimination_order(system.corners, free_corners(diagonal));
  const VectorXd scale = diagonal.cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const SparseMatrix matrix = scaled_free_part(s, free, scale);
  const MatrixXd b = (scale.asDiagonal() * constraint(system, fields, signal))(free, Eigen::all);

  // Flat parts leave S singular (a trilinear function can vanish on a plane), so what is factorised
  // is shifted a little; refining against the unshifted matrix takes the shift's bias out again.
  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>> factors;
  factors.setShift(1e-12);
  factors.compute(matrix);
  BURNISH_CHECK(factors.info() == Eigen::Success, "a scaled positive matrix has its factors");

  Solution solution;
  solution.displacement = MatrixXd::Zero(signal.rows(), signal.cols());
  solution.pinned = static_cast<int>(signal.rows() - static_cast<int>(free.size()));
  MatrixXd x = MatrixXd::Zero(b.rows(), b.cols());
  const auto spread = [&](const MatrixXd& part) {
    MatrixXd whole = MatrixXd::Zero(signal.rows(), signal.cols());
    whole(free, Eigen::all) = scale(free).asDiagonal() * part;
    return whole;
  };
  for (double first_move = 0; solution.refinements < 10; ++solution.refinements) {
    const MatrixXd correction = factors.solve(b - matrix * x);
    x += correction;
    solution.last_move = largest_move(system, spread(correction));
    first_move = std::max(first_move, solution.last_move);
    if (solution.last_move <= 1e-13 * first_move) break;
  }
  solution.displacement = spread(x);
  if (b.norm() > 0) solution.residual = (b - matrix * x).norm() / b.norm();
  return solution;
}

std::vector<Vec3d> displaced_vertices(const System& system, const MatrixXd& displacement) {
  const MatrixXd moves = system.cell_size * evaluate(system, displacement);
  std::vector<Vec3d> moved = system.vertices;
  for (size_t v = 0; v < moved.size(); ++v) moved[v] += moves.row(v).transpose();
  return moved;
}

std::vector<Vec3d> edited_vertices(const System& system, const std::vector<CellFields>& fields) {
  return displaced_vertices(system, solve(system, fields, corner_positions(system)).displacement);
}

}  // namespace burnish::reference
