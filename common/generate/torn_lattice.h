#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// A square lattice of vertices whose quads can be torn out. Seen from outside, columns run to the
/// right and rows run up.
class TornLattice {
 public:
  explicit TornLattice(int side)
      : side_(side), vertices_(size_t(side) * side), kept_(size_t(side) * side, 1) {}

  Vec3d& vertex(int column, int row) { return vertices_[size_t(row) * side_ + column]; }

  /// Tears out the quads whose lower left vertex does not satisfy keep(column, row, position).
  void keep_where(const std::function<bool(int, int, const Vec3d&)>& keep);

  /// Returns the largest connected piece as a manifold with boundary: quads that touch others only
  /// at one corner are removed too. Each quad is split along its shorter diagonal.
  TriangleMesh largest_piece();

 private:
  uint8_t& kept(int column, int row) { return kept_[size_t(row) * side_ + column]; }
  void tear_pinches();
  std::vector<size_t> take_piece_of(size_t first);
  void keep_largest_piece();

  int side_;  ///< vertices
  std::vector<Vec3d> vertices_;
  std::vector<uint8_t> kept_;  ///< per quad, at its lower left vertex; the last of a row is unused
};

}  // namespace burnish
