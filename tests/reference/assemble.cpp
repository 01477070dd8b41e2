#include "common/base/check.h"
#include "tests/reference/reference.h"

namespace burnish::reference {

using Eigen::MatrixXd;
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

/// (a2/a1) ell1 + (a1/a2) ell2: only ratios count, so user units serve as well as grid units.
static Matrix8d stiffness(const Cell& cell, const CellFields& f) {
  return f.alpha2 / f.alpha1 * cell.ell1 + f.alpha1 / f.alpha2 * cell.ell2;
}

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

std::vector<Vec3d> displaced_vertices(const System& system, const MatrixXd& displacement) {
  const MatrixXd moves = system.cell_size * evaluate(system, displacement);
  std::vector<Vec3d> moved = system.vertices;
  for (size_t v = 0; v < moved.size(); ++v) moved[v] += moves.row(v).transpose();
  return moved;
}

}  // namespace burnish::reference
