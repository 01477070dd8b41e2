#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "common/base/file_budget.h"
#include "common/base/status.h"
#include "common/base/types.h"
#include "common/mesh/rewrite/pictures/texture_charts.h"

namespace burnish {

/// A least-squares system with three values at each point of each chart, one per channel: sums of
/// values are wanted at seams, neighbours are alike, and values are small.
class SeamSystem {
 public:
  using Values = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
  /// The ends of an edge on both sides.
  using Points = std::array<uint32_t, 4>;

  /// The wishes of an edge, one per sample: a sum of the values at its points, which are multiplied
  /// before, is what is given.
  class Wishes {
   public:
    void add(const Eigen::Vector4d& factors, const Vec3d& wanted, double weight) {
      matrix_ += weight * factors * factors.transpose();
      right_ += weight * factors * wanted.transpose();
    }

   private:
    friend class SeamSystem;
    Eigen::Matrix4d matrix_ = Eigen::Matrix4d::Zero();
    Eigen::Matrix<double, 4, 3> right_ = Eigen::Matrix<double, 4, 3>::Zero();
  };

  /// Takes its memory. Needs: the charts outlive this. Fails: resource_exhausted above the number
  /// of seams that it can count.
  static Result<SeamSystem> make(const TextureCharts& charts);

  /// Returns the memory that it takes.
  static uint64_t bytes_of(const TextureCharts& charts);

  void add(const Points& points, const Wishes& wishes);

  /// Returns the values by conjugate gradients. Shapes: (points, 3). Fails: as the budget does.
  /// The same bits for any number of threads.
  Result<Values> solve(const FileBudget& budget);

 private:
  explicit SeamSystem(const TextureCharts& charts);
  void multiply(const Values& x, Values& product) const;
  Eigen::VectorXd diagonal() const;

  const TextureCharts* charts_;
  std::vector<Eigen::Triplet<double, int32_t>> entries_;
  Eigen::SparseMatrix<double, Eigen::RowMajor, int32_t> seams_;
  Values right_;
};

}  // namespace burnish
