#pragma once

#include <memory>

#include "common/mesh/triangle_mesh.h"
#include "server/prepare/prepared_mesh.h"
#include "server/solver/hierarchy/hierarchy.h"
#include "tests/bench/peers/peer.h"

namespace burnish::bench {

/// A screened Poisson equation for the displacement of a scan's surface, with one α and β:
/// (α² M + L) u = (β − 1) L x°.
class LinearSystem {
 public:
  virtual ~LinearSystem() = default;
  /// Returns the matrix. Units: α in user units. The pattern is the same for every α.
  virtual SparseMatrix matrix(double alpha) const = 0;
  /// Returns the right side. Shapes: unknowns × 3.
  MatrixXd right_side(double beta) const { return (beta - 1) * gradient_; }
  /// Returns how far each vertex moves. Shapes: vertices × 3. Units: the file's.
  virtual MatrixXd vertex_moves(const MatrixXd& x) const = 0;
  /// Returns the bytes of M, L and L x°, from which an edit makes its system.
  virtual uint64_t byte_count() const = 0;

 protected:
  MatrixXd gradient_;  ///< L x°
};

inline uint64_t byte_count_of(const SparseMatrix& matrix) {
  return static_cast<uint64_t>(matrix.nonZeros()) * (sizeof(double) + sizeof(int)) +
         static_cast<uint64_t>(matrix.cols() + 1) * sizeof(int);
}

inline uint64_t byte_count_of(const MatrixXd& matrix) {
  return static_cast<uint64_t>(matrix.size()) * sizeof(double);
}

/// Makes the usual system of geometry processing instead of the grid's: the cotangent Laplacian and
/// the lumped mass (a third of each triangle's area) at the scan's own vertices.
std::unique_ptr<LinearSystem> make_cotangent_system(const TriangleMesh& mesh);

/// Makes the product's own system at the finest depth, summed here from the prepared integrals.
/// Corners with almost no surface are pinned like in the product. The diagonal is raised by 1e-13
/// of itself: factors in double need it if a flat part makes S singular. Needs: both outlive the
/// system.
std::unique_ptr<LinearSystem> make_grid_system(const PreparedMesh& prepared,
                                               const Hierarchy& hierarchy);

}  // namespace burnish::bench
