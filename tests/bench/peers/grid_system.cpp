#include <algorithm>
#include <numeric>

#include "common/evaluation/evaluation.h"
#include "server/solver/hierarchy/cell_matrix.h"
#include "tests/bench/peers/linear_system.h"

namespace burnish::bench {
namespace {

constexpr double kPinRatio = 1e-12;     // of the median diagonal
constexpr double kFactorShift = 1e-13;  // of the own diagonal

/// Returns a matrix with the stencil's pattern and the diagonal, all zero.
SparseMatrix make_pattern(const Stencil& stencil, int32_t corners) {
  std::vector<int> start(static_cast<size_t>(corners) + 1);
  for (int32_t i = 0; i <= corners; ++i) start[i] = static_cast<int>(stencil.row_start[i]) + i;
  std::vector<int> column(static_cast<size_t>(start[corners]));
  for (int32_t i = 0; i < corners; ++i) {
    const auto begin = column.begin() + start[i];
    const auto end = column.begin() + start[i + 1];
    std::copy(stencil.column.begin() + stencil.row_start[i],
              stencil.column.begin() + stencil.row_start[i + 1], begin);
    *(end - 1) = i;
    std::sort(begin, end);
  }
  const std::vector<double> zeros(column.size(), 0);
  return Eigen::Map<const SparseMatrix>(corners, corners, start[corners], start.data(),
                                        column.data(), zeros.data());
}

/// The places of a cell's 8×8 share among the matrix's values.
class CellEntries {
 public:
  CellEntries(SparseMatrix& matrix, const std::array<int32_t, kCornersPerCell>& corners) {
    for (int b = 0; b < kCornersPerCell; ++b) {
      const int* begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[corners[b]];
      const int* end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[corners[b] + 1];
      for (int a = 0; a < kCornersPerCell; ++a)
        at_[a][b] = std::lower_bound(begin, end, corners[a]) - matrix.innerIndexPtr();
    }
  }

  /// Off-diagonals come as pairs. Each diagonal is its row's sum less its pairs.
  template <typename Pair, typename RowSum>
  void add(SparseMatrix& matrix, Pair&& pair, RowSum&& row_sum) const {
    double* values = matrix.valuePtr();
    for (int a = 0; a < kCornersPerCell; ++a) {
      values[at_[a][a]] += row_sum(a);
      for (int b = 0; b < kCornersPerCell; ++b) {
        if (a == b) continue;
        values[at_[a][b]] += pair(pair_index(a, b));
        values[at_[a][a]] -= pair(pair_index(a, b));
      }
    }
  }

 private:
  std::array<std::array<std::ptrdiff_t, kCornersPerCell>, kCornersPerCell> at_;
};

class GridSystem final : public LinearSystem {
 public:
  GridSystem(const PreparedMesh& prepared, const Hierarchy& hierarchy)
      : prepared_(prepared), grid_(hierarchy.at(hierarchy.finest).grid) {
    stiffness_ = make_pattern(hierarchy.at(hierarchy.finest).stencil, grid_.corner_count());
    mass_ = stiffness_;
    gradient_.setZero(grid_.corner_count(), 3);
    for (int32_t c = 0; c < grid_.cell_count(); ++c) {
      const CellIntegrals& cell = prepared.integrals[c];
      const auto& corners = grid_.cell_corners[c];
      const CellEntries entries(mass_, corners);
      entries.add(
          mass_, [&](int p) { return cell.mass[p]; }, [&](int a) { return cell.mass_row_sum[a]; });
      const auto stiffness = [&](int p) { return cell.stiffness[0][p] + cell.stiffness[1][p]; };
      entries.add(stiffness_, stiffness, [](int) { return 0; });
      for (int a = 0; a < kCornersPerCell; ++a)
        for (int axis = 0; axis < 3; ++axis)
          gradient_(corners[a], axis) += gradient_of(stiffness, a, axis);
    }
  }

  SparseMatrix matrix(double alpha) const override {
    const double alpha_in_grid_units = alpha * prepared_.alpha_scale();
    SparseMatrix sum = stiffness_;
    sum.coeffs() += alpha_in_grid_units * alpha_in_grid_units * mass_.coeffs();
    pin(sum);
    return sum;
  }

  MatrixXd vertex_moves(const MatrixXd& x) const override {
    std::vector<Vec3d> displacement(static_cast<size_t>(x.rows()));
    for (Eigen::Index i = 0; i < x.rows(); ++i) displacement[i] = x.row(i);
    const auto vertices = static_cast<Eigen::Index>(prepared_.vertices.size());
    MatrixXd moves(vertices, 3);
    for (Eigen::Index v = 0; v < vertices; ++v)
      moves.row(v) =
          prepared_.frame.cell_size * evaluate<Vec3d>(grid_, prepared_.evaluation[v], displacement);
    return moves;
  }

  uint64_t byte_count() const override {
    return byte_count_of(stiffness_) + byte_count_of(mass_) + byte_count_of(gradient_);
  }

 private:
  // Entries stay in the pattern as zeros, so one analysis serves every α.
  static void pin(SparseMatrix& matrix) {
    Eigen::VectorXd diagonal = matrix.diagonal();
    std::vector<double> sorted(diagonal.begin(), diagonal.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double least = kPinRatio * *middle;
    for (int column = 0; column < matrix.cols(); ++column)
      for (SparseMatrix::InnerIterator it(matrix, column); it; ++it) {
        if (it.row() == column)
          it.valueRef() = diagonal[column] > least ? (1 + kFactorShift) * it.value() : 1;
        else if (!(diagonal[column] > least && diagonal[it.row()] > least))
          it.valueRef() = 0;
      }
  }

  const PreparedMesh& prepared_;
  const SparseGrid& grid_;
  SparseMatrix stiffness_, mass_;  // of one pattern
};

}  // namespace

std::unique_ptr<LinearSystem> make_grid_system(const PreparedMesh& prepared,
                                               const Hierarchy& hierarchy) {
  return std::make_unique<GridSystem>(prepared, hierarchy);
}

}  // namespace burnish::bench
