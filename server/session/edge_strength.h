#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "common/grid/sparse_grid.h"
#include "server/fields/fields.h"

namespace burnish {

/// The strength of kept edges in each cell and at each vertex, of three sources: what is set for
/// the whole scan, paint over it, and what is held.
class EdgeStrength {
 public:
  /// Needs: both outlive this.
  EdgeStrength(const PreparedMesh& prepared, const SparseGrid& grid)
      : prepared_(prepared), grid_(grid) {}

  /// Takes the fields' paint and what they hold, and `strength` of unpainted cells. Costs nothing
  /// if they are as before, nor for another strength without paint.
  void take(const Fields& fields, double strength);

  double most() const { return most_; }
  /// Returns how much of most() counts. Shapes: one per cell; empty: all of it in all.
  std::span<const float> in_cells() const { return cells_; }
  /// Likewise. Shapes: one per vertex. A vertex in a held cell has 0.
  std::span<const float> at_vertices() const { return vertices_; }
  /// Returns a number that other cells and vertices have another of.
  uint64_t version() const { return version_; }
  uint64_t byte_count() const { return (cells_.size() + vertices_.size()) * sizeof(float); }

 private:
  struct Sources {
    std::shared_ptr<const Hold> hold;  // null if it holds nothing
    bool is_painted = false;
    uint64_t paint = 0;
    double strength = 0;  // of unpainted cells; only beside paint
    bool operator==(const Sources&) const = default;
  };

  void make_cells(const PaintLayer* paint);
  std::vector<float> corners() const;
  void make_vertices();

  const PreparedMesh& prepared_;
  const SparseGrid& grid_;
  double most_ = 0;
  Sources sources_;
  std::vector<float> cells_, vertices_;
  uint64_t version_ = 0;
};

}  // namespace burnish
