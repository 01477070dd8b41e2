#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/grid/sparse_grid.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// The surface near a stroke, to find what of it hangs together with the place that a dab touches.
/// The nodes are the sheets of cells: one sheet for each cell, or one for each component of the
/// mesh that passes through it. Passages lead from sheet to sheet. Ways go through the centres of
/// the sheets.
///
/// Two parts of one component in the same cell are one sheet. So a wall thinner than about a cell
/// and a half does not hold the brush back.
class SurfaceNear {
 public:
  /// Needs: prepared outlives this; `cells` rising, with all that meet the ball of a dab.
  SurfaceNear(const PreparedMesh& prepared, std::vector<int64_t> cells);

  const std::vector<int64_t>& cells() const { return cells_; }

  /// Begins at the cell with the dab's centre. If this has no surface, begins at the cell whose
  /// surface is nearest, within the radius. Units: file units.
  void begin(const Vec3d& centre, double radius);

  /// A cell that meets the ball.
  struct Reached {
    size_t index;     ///< of cells()
    double distance;  ///< of its middle from the centre, file units; see kDetour
  };

  /// Returns the next cells, farther along the surface than those before. Returns none at the end.
  /// Each cell comes once.
  std::span<const Reached> next_ring();

  /// The way along the surface over the straight distance, up to which the straight one counts.
  /// Beyond, a cell is as far as the way over this. Slopes, noise and the steps between cells
  /// lengthen ways by less, so dabs are round there. Around the rim of a wall the paint fades.
  static constexpr double kDetour = 1.5;
  static constexpr double kSlackCells = 2;  ///< of each way: from the centres to points in cells

 private:
  static constexpr float kFar = 1e30f;

  struct Node {
    int32_t index;  // of the cell in cells_
    int32_t sheet;  // of PreparedMesh::sheets; kNone: the cell has one sheet
    Vec3i cell;
    Vec3f centre = Vec3f::Constant(kFar);  // of the sheet, grid units; kFar: not looked for yet
    int32_t first = kNone, last = kNone;   // in neighbours_; kNone: not looked for yet
    float way = kFar, led_on = kFar;       // from the dab, in cells; the way when it last led on
  };

  void add_nodes();
  void find_neighbours(Node& node);
  uint32_t passages_of(const Node& node) const;
  bool hang_together(const Node& node, const Node& other, int slot) const;
  Vec3f centre_of(const Node& node) const;
  int64_t touched_cell() const;
  int64_t index_of(const Vec3i& cell, size_t begin) const;
  double box_distance(const Vec3i& cell) const;
  void lead_to(int32_t number, const Node* from);
  void lead_on(int32_t number);
  double distance_of(size_t index) const;

  const PreparedMesh& prepared_;
  const std::vector<int64_t> cells_;
  std::vector<MortonKey> keys_;      // per cell
  std::vector<int32_t> first_node_;  // per cell, and the end
  std::vector<Node> nodes_;
  std::vector<int32_t> neighbours_;

  // Facts about one dab, in grid units; centre_ is not.
  Vec3d centre_, grid_centre_;
  double radius_ = 0;
  std::vector<int32_t> met_;                 // nodes with a way
  std::vector<std::vector<int32_t>> rings_;  // nodes by their way; some twice
  size_t ring_ = 0;
  uint32_t dab_ = 0;
  std::vector<uint32_t> seen_;  // per cell: the last dab that reached it
  std::vector<Reached> reached_;
};

}  // namespace burnish
