// Eigen's conjugate gradients. Rows instead of columns, and both triangles, let its product use all
// threads. Compiled without EIGEN_DONT_PARALLELIZE, unlike the product.

#include <Eigen/IterativeLinearSolvers>

#include "tests/bench/peers/peer.h"

namespace burnish::bench {
namespace {

using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
constexpr int kIterationsMax = 3000;

template <typename Preconditioner>
class EigenCgPeer final : public Peer {
 public:
  Status analyse(const SparseMatrix& /*matrix*/, uint64_t /*bytes_max*/) override {
    return Status::ok();
  }

  Status factor(const SparseMatrix& matrix) override {
    matrix_ = matrix;
    solver_.compute(matrix_);
    if (solver_.info() == Eigen::Success) return Status::ok();
    return internal_error("Eigen CG's preconditioner failed");
  }

  Result<int> solve(const MatrixXd& b, double tolerance, MatrixXd& x) override {
    solver_.setTolerance(tolerance);
    solver_.setMaxIterations(kIterationsMax);
    int iterations = 0;
    for (int column = 0; column < b.cols(); ++column) {
      x.col(column) = solver_.solveWithGuess(b.col(column), x.col(column)).eval();
      iterations += static_cast<int>(solver_.iterations());
      if (solver_.info() != Eigen::Success)
        return internal_error("Eigen CG did not converge in " + std::to_string(kIterationsMax) +
                              " iterations");
    }
    return iterations;
  }

  uint64_t byte_count() const override {
    const auto entries = static_cast<uint64_t>(matrix_.nonZeros());
    const auto rows = static_cast<uint64_t>(matrix_.rows());
    return entries * (sizeof(double) + sizeof(int)) + preconditioner_bytes() +
           5 * rows * sizeof(double);  // the vectors of an iteration
  }

 private:
  uint64_t preconditioner_bytes() const {
    const auto rows = static_cast<uint64_t>(matrix_.rows());
    if constexpr (std::is_same_v<Preconditioner, Eigen::DiagonalPreconditioner<double>>)
      return rows * sizeof(double);
    else
      return static_cast<uint64_t>(solver_.preconditioner().matrixL().nonZeros()) *
                 (sizeof(double) + sizeof(int)) +
             rows * (sizeof(double) + sizeof(int));
  }

  RowMatrix matrix_;
  Eigen::ConjugateGradient<RowMatrix, Eigen::Lower | Eigen::Upper, Preconditioner> solver_;
};

}  // namespace

std::unique_ptr<Peer> make_eigen_cg_diagonal() {
  return std::make_unique<EigenCgPeer<Eigen::DiagonalPreconditioner<double>>>();
}

std::unique_ptr<Peer> make_eigen_cg_incomplete() {
  return std::make_unique<EigenCgPeer<Eigen::IncompleteCholesky<double>>>();
}

}  // namespace burnish::bench
