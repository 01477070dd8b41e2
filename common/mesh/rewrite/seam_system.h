#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/SparseCore>

#include "common/base/file_budget.h"
#include "common/base/status.h"
#include "common/base/types.h"
#include "common/mesh/rewrite/texture_charts.h"

namespace burnish {

/// A least-squares system with three values at each point of each chart, one per channel: sums of
/// values are wanted at seams, neighbours are alike, and values are small.
class SeamSystem {
 public:
  using Values = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
  /// Points and what multiplies their values.
  using Terms = std::array<std::pair<uint32_t, double>, 4>;

  /// Needs: the charts outlive this.
  explicit SeamSystem(const TextureCharts& charts);

  /// Returns the memory that it takes.
  static uint64_t bytes_of(const TextureCharts& charts);

  /// Wants the sum of these terms to be `wanted`.
  void add(const Terms& terms, const Vec3d& wanted, double weight);

  /// Returns the values by conjugate gradients. Shapes: (points, 3). Fails: as the budget does.
  /// The same bits for any number of threads.
  Result<Values> solve(const FileBudget& budget);

 private:
  void multiply(const Values& x, Values& product) const;
  Eigen::VectorXd diagonal() const;

  const TextureCharts& charts_;
  std::vector<Eigen::Triplet<double, int32_t>> entries_;
  Eigen::SparseMatrix<double, Eigen::RowMajor, int32_t> seams_;
  Values right_;
};

}  // namespace burnish
