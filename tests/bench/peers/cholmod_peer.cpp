// CHOLMOD's supernodal LLᵀ with its own choice of ordering (AMD, or METIS if that leaves less).

#include <cholmod.h>

#include "tests/bench/peers/peer.h"

namespace burnish::bench {
namespace {

/// Its arrays are the matrix's own; only the lower triangle is read.
cholmod_sparse view_of(const SparseMatrix& matrix) {
  cholmod_sparse view = {};
  view.nrow = view.ncol = static_cast<size_t>(matrix.rows());
  view.nzmax = static_cast<size_t>(matrix.nonZeros());
  view.p = const_cast<int*>(matrix.outerIndexPtr());
  view.i = const_cast<int*>(matrix.innerIndexPtr());
  view.x = const_cast<double*>(matrix.valuePtr());
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = view.packed = 1;
  return view;
}

cholmod_dense view_of(const MatrixXd& b) {
  cholmod_dense view = {};
  view.nrow = view.d = static_cast<size_t>(b.rows());
  view.ncol = static_cast<size_t>(b.cols());
  view.nzmax = static_cast<size_t>(b.size());
  view.x = const_cast<double*>(b.data());
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  return view;
}

class CholmodPeer final : public Peer {
 public:
  CholmodPeer() {
    cholmod_start(&common_);
    common_.supernodal = CHOLMOD_SUPERNODAL;
    common_.print = 0;
  }
  ~CholmodPeer() override {
    cholmod_free_dense(&x_, &common_);
    cholmod_free_dense(&y_, &common_);
    cholmod_free_dense(&e_, &common_);
    cholmod_free_factor(&factor_, &common_);
    cholmod_finish(&common_);
  }

  Status analyse(const SparseMatrix& matrix, uint64_t bytes_max) override {
    cholmod_sparse a = view_of(matrix);
    factor_ = cholmod_analyze(&a, &common_);
    RETURN_IF_ERROR(outcome("analysis"));
    const uint64_t bytes = factor_->xsize * sizeof(double);
    if (bytes <= bytes_max) return Status::ok();
    return resource_exhausted("CHOLMOD's factor takes " + std::to_string(bytes >> 20) +
                              " MiB, more than the " + std::to_string(bytes_max >> 20) +
                              " MiB that --mebibytes allows");
  }

  Status factor(const SparseMatrix& matrix) override {
    cholmod_sparse a = view_of(matrix);
    cholmod_factorize(&a, factor_, &common_);
    return outcome("factorisation");
  }

  // cholmod_solve2 keeps its work space between calls, which is the fastest way.
  Result<int> solve(const MatrixXd& b, double /*tolerance*/, MatrixXd& x) override {
    cholmod_dense right = view_of(b);
    cholmod_solve2(CHOLMOD_A, factor_, &right, nullptr, &x_, nullptr, &y_, &e_, &common_);
    RETURN_IF_ERROR(outcome("solve"));
    x = Eigen::Map<const MatrixXd>(static_cast<const double*>(x_->x), b.rows(), b.cols());
    return 0;
  }

  uint64_t byte_count() const override { return common_.memory_inuse; }

  std::string note() const override {
    const int ordering = common_.method[common_.selected].ordering;
    const std::string name = ordering == CHOLMOD_METIS ? "METIS"
                             : ordering == CHOLMOD_AMD ? "AMD"
                                                       : std::to_string(ordering);
    return "ordering " + name + ", " + std::to_string(factor_->xsize) + " numbers in L, peak " +
           std::to_string(common_.memory_usage >> 20) + " MiB";
  }

 private:
  Status outcome(const std::string& phase) const {
    if (common_.status == CHOLMOD_OK) return Status::ok();
    return internal_error("CHOLMOD's " + phase + " ended with status " +
                          std::to_string(common_.status));
  }

  cholmod_common common_ = {};
  cholmod_factor* factor_ = nullptr;
  cholmod_dense* x_ = nullptr;
  cholmod_dense* y_ = nullptr;
  cholmod_dense* e_ = nullptr;
};

}  // namespace

std::unique_ptr<Peer> make_cholmod() {
  return std::make_unique<CholmodPeer>();
}

}  // namespace burnish::bench
