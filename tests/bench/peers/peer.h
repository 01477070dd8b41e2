#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "common/base/status.h"

namespace burnish::bench {

/// Symmetric positive definite, both triangles stored.
using SparseMatrix = Eigen::SparseMatrix<double>;
using Eigen::MatrixXd;

/// A foreign solver for A x = b with three columns.
class Peer {
 public:
  virtual ~Peer() = default;
  /// Does the work that depends on the pattern alone. Fails: resource_exhausted if the need of
  /// factor() is known and above `bytes_max`.
  virtual Status analyse(const SparseMatrix& matrix, uint64_t bytes_max) = 0;
  /// Makes the factors, or the preconditioner. Needs: analyse() with this pattern; the matrix lives
  /// as long as solve() is called.
  virtual Status factor(const SparseMatrix& matrix) = 0;
  /// An iterative peer starts at `x` and stops at the relative residual `tolerance`. A direct peer
  /// ignores both. Returns the iterations of all columns together; 0 for a direct peer.
  virtual Result<int> solve(const MatrixXd& b, double tolerance, MatrixXd& x) = 0;
  /// Returns the bytes that it keeps between solves, with its own copy of the matrix.
  virtual uint64_t byte_count() const = 0;
  /// Returns a note for the reader of the figures.
  virtual std::string note() const { return ""; }
};

struct PeerKind {
  std::string_view name;
  bool is_iterative;
  bool is_threaded;                 ///< false if a second thread changes nothing
  std::unique_ptr<Peer> (*make)();  ///< null if this build lacks the library
};

/// Returns all peers that the bench knows, even those that this build lacks.
std::span<const PeerKind> peer_kinds();

// CHOLMOD and hypre are linked only if the build finds them.
std::unique_ptr<Peer> make_cholmod();
std::unique_ptr<Peer> make_eigen_ldlt();
std::unique_ptr<Peer> make_eigen_cg_diagonal();
std::unique_ptr<Peer> make_eigen_cg_incomplete();
std::unique_ptr<Peer> make_hypre();

}  // namespace burnish::bench
