#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/groups.h"
#include "common/base/scratch_array.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// The equation of a signal on the scan's own triangles (docs/solver.md, "Colours"): linear finite
/// elements. It knows details that are finer than a cell. Its conjugate gradients begin at the
/// grid's solution, which has all that is larger, so a few steps do. Vertices at one place are one.
/// The same bits for any number of threads.
class MeshSignal {
 public:
  /// Needs: `prepared` outlives it. Shapes: one value per vertex.
  MeshSignal(const PreparedMesh& prepared, std::span<const Vec3f> values);

  /// Begins at a change. Shapes: per cell how far β is above 1; one change per vertex.
  /// Units: users' α.
  void begin(double alpha, std::span<const float> beta_above_one, std::span<const Vec3f> change);

  /// Does one step. Returns how far it moves a vertex at most.
  float step();

  /// Returns the change of the vertices, valid until the next call.
  std::vector<Vec3f> change() const;

  uint64_t byte_count() const;

 private:
  using Slope = Eigen::Vector2f;
  using Slopes = Eigen::Matrix<float, 2, 3>;  // of three channels

  /// A triangle: its area, cells², and the gradients of the hats of its first two corners times the
  /// root of the area. The third is minus their sum, so a constant has no slope.
  struct Element {
    std::array<Slope, 2> hat = {Slope::Zero(), Slope::Zero()};
    float area = 0;  // 0: the triangle has none, and counts for nothing
  };

  static Element element_of(const Vec3d& a, const Vec3d& b, const Vec3d& c);
  std::array<uint32_t, 3> nodes_of(uint32_t triangle) const;
  Slopes slopes(uint32_t triangle, std::span<const Vec3f> values) const;
  Slope hat(uint32_t triangle, int corner) const;
  Vec3f row_times(uint32_t node, std::span<const Vec3f> values) const;
  Vec3f right_side(uint32_t node, std::span<const float> beta_above_one) const;
  float diagonal(uint32_t node) const;
  double residual_energy() const;
  int32_t count() const { return static_cast<int32_t>(place_.size()); }

  const PreparedMesh& prepared_;
  ScratchArray<uint32_t> place_;         // per vertex: the least vertex at its place, its node
  std::vector<Element> elements_;        // per triangle
  Groups<uint32_t, int64_t> around_;     // the triangles of a node
  std::vector<Vec3f> values_;            // per node: the mean of its vertices
  double square_alpha_ = 0;              // grid units
  std::vector<float> inverse_diagonal_;  // 0 for vertices that are no nodes
  std::vector<Vec3f> solution_, residual_, direction_, product_;
  double energy_ = 0;  // of the residual before the last step; 0: there was none
};

/// Returns the bytes that a MeshSignal of this mesh takes at most.
uint64_t predict_mesh_signal_bytes(const PreparedMesh& prepared);

}  // namespace burnish
