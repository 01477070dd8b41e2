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

/// A solver of somebody else's, for A x = b with three columns.
class Peer {
 public:
  virtual ~Peer() = default;
  /// What depends on the pattern alone. Fails: resource_exhausted when what factor() would take is
  /// known and above `bytes_max`.
  virtual Status analyse(const SparseMatrix& matrix, uint64_t bytes_max) = 0;
  /// The factors, or the preconditioner. Needs: analyse() with this pattern; the matrix lives as
  /// long as solve() is called.
  virtual Status factor(const SparseMatrix& matrix) = 0;
  /// An iterative peer starts at `x` and stops at the relative residual `tolerance`; a direct one
  /// heeds neither. Returns the iterations of all columns together, 0 of a direct peer.
  virtual Result<int> solve(const MatrixXd& b, double tolerance, MatrixXd& x) = 0;
  /// What it keeps between solves, its own copy of the matrix included.
  virtual uint64_t byte_count() const = 0;
  /// Whatever a reader of the figures should know.
  virtual std::string note() const { return ""; }
};

struct PeerKind {
  std::string_view name;
  bool is_iterative;
  bool is_threaded;                 ///< false: a second thread changes nothing
  std::unique_ptr<Peer> (*make)();  ///< null where this build lacks the library
};

/// All that the bench knows; those that are missing here too.
std::span<const PeerKind> peer_kinds();

// CHOLMOD and hypre are linked only where the build finds them.
std::unique_ptr<Peer> make_cholmod();
std::unique_ptr<Peer> make_eigen_ldlt();
std::unique_ptr<Peer> make_eigen_cg_diagonal();
std::unique_ptr<Peer> make_eigen_cg_incomplete();
std::unique_ptr<Peer> make_hypre();

}  // namespace burnish::bench
