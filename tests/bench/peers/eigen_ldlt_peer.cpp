// Eigen's simplicial LDLᵀ, ordered by approximate minimum degree.

#include <Eigen/SparseCholesky>

#include "tests/bench/peers/peer.h"

namespace burnish::bench {
namespace {

class EigenLdltPeer final : public Peer {
 public:
  Status analyse(const SparseMatrix& matrix, uint64_t /*bytes_max*/) override {
    solver_.analyzePattern(matrix);
    return outcome("analysis");
  }

  Status factor(const SparseMatrix& matrix) override {
    solver_.factorize(matrix);
    return outcome("factorisation");
  }

  Result<int> solve(const MatrixXd& b, double /*tolerance*/, MatrixXd& x) override {
    x = solver_.solve(b);
    RETURN_IF_ERROR(outcome("solve"));
    return 0;
  }

  uint64_t byte_count() const override {
    const uint64_t rows = static_cast<uint64_t>(solver_.rows());
    return entries() * (sizeof(double) + sizeof(int)) +
           rows * (sizeof(double) + 5 * sizeof(int));  // D, column starts, tree, permutations
  }

  std::string note() const override { return std::to_string(entries()) + " numbers in L"; }

 private:
  uint64_t entries() const {
    return static_cast<uint64_t>(solver_.matrixL().nestedExpression().nonZeros());
  }

  Status outcome(const std::string& phase) const {
    if (solver_.info() == Eigen::Success) return Status::ok();
    return internal_error("Eigen LDLT's " + phase + " failed");
  }

  Eigen::SimplicialLDLT<SparseMatrix> solver_;
};

}  // namespace

std::unique_ptr<Peer> make_eigen_ldlt() {
  return std::make_unique<EigenLdltPeer>();
}

}  // namespace burnish::bench
