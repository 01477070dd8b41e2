// Conjugate gradients around one V-cycle of hypre's BoomerAMG, with its defaults. Debian's build
// has no OpenMP: it would use a second core through MPI only, as a second process.

#include <HYPRE.h>
#include <HYPRE_IJ_mv.h>
#include <HYPRE_krylov.h>
#include <HYPRE_parcsr_ls.h>
#include <malloc.h>
#include <numeric>
#include <vector>

#include "tests/bench/peers/peer.h"

namespace burnish::bench {
namespace {

constexpr int kIterationsMax = 1000;

uint64_t allocated_bytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

/// A process may start MPI only once.
void start_hypre() {
  static const bool started = [] {
    MPI_Init(nullptr, nullptr);
    HYPRE_Init();
    std::atexit([] {
      HYPRE_Finalize();
      MPI_Finalize();
    });
    return true;
  }();
  (void)started;
}

class HypreVector {
 public:
  explicit HypreVector(const std::vector<HYPRE_BigInt>& rows) : rows_(rows) {
    HYPRE_IJVectorCreate(MPI_COMM_SELF, 0, static_cast<HYPRE_BigInt>(rows.size()) - 1, &vector_);
    HYPRE_IJVectorSetObjectType(vector_, HYPRE_PARCSR);
  }
  ~HypreVector() { HYPRE_IJVectorDestroy(vector_); }
  HypreVector(const HypreVector&) = delete;
  HypreVector& operator=(const HypreVector&) = delete;

  HYPRE_ParVector set(const double* values) {
    HYPRE_IJVectorInitialize(vector_);
    HYPRE_IJVectorSetValues(vector_, count(), rows_.data(), values);
    HYPRE_IJVectorAssemble(vector_);
    void* object = nullptr;
    HYPRE_IJVectorGetObject(vector_, &object);
    return static_cast<HYPRE_ParVector>(object);
  }
  void get(double* values) { HYPRE_IJVectorGetValues(vector_, count(), rows_.data(), values); }

 private:
  int count() const { return static_cast<int>(rows_.size()); }
  const std::vector<HYPRE_BigInt>& rows_;
  HYPRE_IJVector vector_ = nullptr;
};

class HyprePeer final : public Peer {
 public:
  HyprePeer() { start_hypre(); }
  ~HyprePeer() override { release(); }

  Status analyse(const SparseMatrix& /*matrix*/, uint64_t /*bytes_max*/) override {
    return Status::ok();
  }

  Status factor(const SparseMatrix& matrix) override {
    release();
    const uint64_t before = allocated_bytes();
    copy_matrix(matrix);
    HYPRE_BoomerAMGCreate(&amg_);
    HYPRE_BoomerAMGSetTol(amg_, 0);
    HYPRE_BoomerAMGSetMaxIter(amg_, 1);
    HYPRE_ParCSRPCGCreate(MPI_COMM_SELF, &pcg_);
    HYPRE_PCGSetMaxIter(pcg_, kIterationsMax);
    HYPRE_PCGSetTwoNorm(pcg_, 1);
    HYPRE_PCGSetPrecond(pcg_, reinterpret_cast<HYPRE_PtrToSolverFcn>(HYPRE_BoomerAMGSolve),
                        reinterpret_cast<HYPRE_PtrToSolverFcn>(HYPRE_BoomerAMGSetup), amg_);
    HypreVector b(rows_), x(rows_);
    const std::vector<double> zeros(rows_.size(), 0);
    HYPRE_ParCSRPCGSetup(pcg_, csr_, b.set(zeros.data()), x.set(zeros.data()));
    bytes_ = allocated_bytes() - before;
    return outcome("setup");
  }

  Result<int> solve(const MatrixXd& b, double tolerance, MatrixXd& x) override {
    HYPRE_PCGSetTol(pcg_, tolerance);
    HypreVector right(rows_), solution(rows_);
    int iterations = 0;
    for (int column = 0; column < b.cols(); ++column) {
      HYPRE_ParCSRPCGSolve(pcg_, csr_, right.set(b.col(column).data()),
                           solution.set(x.col(column).data()));
      solution.get(x.col(column).data());
      HYPRE_Int of_column = 0;
      HYPRE_PCGGetNumIterations(pcg_, &of_column);
      iterations += of_column;
    }
    RETURN_IF_ERROR(outcome("solve"));
    return iterations;
  }

  uint64_t byte_count() const override { return bytes_; }

 private:
  // The matrix is symmetric: its columns serve as rows.
  void copy_matrix(const SparseMatrix& matrix) {
    const auto n = static_cast<size_t>(matrix.rows());
    rows_.resize(n);
    std::iota(rows_.begin(), rows_.end(), 0);
    std::vector<HYPRE_Int> counts(n);
    for (size_t i = 0; i < n; ++i)
      counts[i] = matrix.outerIndexPtr()[i + 1] - matrix.outerIndexPtr()[i];
    const HYPRE_BigInt last = static_cast<HYPRE_BigInt>(n) - 1;
    HYPRE_IJMatrixCreate(MPI_COMM_SELF, 0, last, 0, last, &matrix_);
    HYPRE_IJMatrixSetObjectType(matrix_, HYPRE_PARCSR);
    HYPRE_IJMatrixSetRowSizes(matrix_, counts.data());
    HYPRE_IJMatrixInitialize(matrix_);
    HYPRE_IJMatrixSetValues(matrix_, static_cast<HYPRE_Int>(n), counts.data(), rows_.data(),
                            matrix.innerIndexPtr(), matrix.valuePtr());
    HYPRE_IJMatrixAssemble(matrix_);
    void* object = nullptr;
    HYPRE_IJMatrixGetObject(matrix_, &object);
    csr_ = static_cast<HYPRE_ParCSRMatrix>(object);
  }

  static Status outcome(const std::string& phase) {
    const HYPRE_Int error = HYPRE_GetError();
    HYPRE_ClearAllErrors();
    if (error == 0) return Status::ok();
    return internal_error("hypre's " + phase + " ended with error " + std::to_string(error));
  }

  void release() {
    if (pcg_ != nullptr) HYPRE_ParCSRPCGDestroy(pcg_);
    if (amg_ != nullptr) HYPRE_BoomerAMGDestroy(amg_);
    if (matrix_ != nullptr) HYPRE_IJMatrixDestroy(matrix_);
    pcg_ = amg_ = nullptr;
    matrix_ = nullptr;
  }

  std::vector<HYPRE_BigInt> rows_;
  HYPRE_IJMatrix matrix_ = nullptr;
  HYPRE_ParCSRMatrix csr_ = nullptr;
  HYPRE_Solver amg_ = nullptr;
  HYPRE_Solver pcg_ = nullptr;
  uint64_t bytes_ = 0;
};

}  // namespace

std::unique_ptr<Peer> make_hypre() {
  return std::make_unique<HyprePeer>();
}

}  // namespace burnish::bench
