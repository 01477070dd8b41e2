#include "server/fields/rims.h"

#include <algorithm>
#include <cmath>

#include "common/grid/sparse_grid.h"
#include "common/grid/stencil_slots.h"
#include "common/mesh/components.h"
#include "server/fields/cell_layers.h"
#include "server/fields/edge_census.h"

namespace burnish {
namespace {

constexpr double kSampleCells = 0.25;

/// The pieces of the surface, by the vertices in each cell.
class Pieces {
 public:
  Pieces(const PreparedMesh& prepared, const EdgeCensus& census)
      : prepared_(prepared),
        piece_(component_roots(census.triangles, prepared.vertices.size())),
        least_(prepared.cells.size(), kNone),
        most_(prepared.cells.size(), kNone) {
    for (const Triangle& triangle : census.triangles)
      for (const uint32_t v : triangle) note(prepared.evaluation[v].cell, piece_[v]);
  }

  /// Returns whether another piece is in the cells around the middle of an edge.
  bool is_beside_another(const RimEdge& edge) const {
    const Vec3d middle = (grid_point(edge.from) + grid_point(edge.to)) / 2;
    const Vec3i place = middle.array().floor().cast<int>();
    for (int slot = 0; slot < kSlots; ++slot) {
      const Vec3i offset(slot % 3 - 1, slot / 3 % 3 - 1, slot / 9 - 1);
      if (has_other(find_cell(prepared_, place + offset), piece_[edge.from])) return true;
    }
    return false;
  }

  Vec3d grid_point(uint32_t vertex) const {
    return prepared_.frame.to_grid(prepared_.vertices[vertex]);
  }

 private:
  bool has_other(int32_t cell, int32_t piece) const {
    return cell != kNone && least_[cell] != kNone &&
           (least_[cell] != piece || most_[cell] != piece);
  }

  void note(int32_t cell, int32_t piece) {
    if (cell == kNone) return;
    least_[cell] = least_[cell] == kNone ? piece : std::min(least_[cell], piece);
    most_[cell] = std::max(most_[cell], piece);
  }

  const PreparedMesh& prepared_;
  std::vector<int32_t> piece_;         // per vertex
  std::vector<int32_t> least_, most_;  // per cell: the pieces of its vertices
};

void add_cells(const PreparedMesh& prepared, const Vec3d& from, const Vec3d& to,
               std::vector<int32_t>& cells) {
  const int samples = static_cast<int>(std::ceil((to - from).norm() / kSampleCells));
  for (int i = 0; i <= samples; ++i) {
    const Vec3d at = from + (to - from) * (double(i) / std::max(samples, 1));
    const int32_t cell = find_cell(prepared, at.array().floor().cast<int>());
    if (cell != kNone) cells.push_back(cell);
  }
}

}  // namespace

std::vector<int32_t> rim_cells(const PreparedMesh& prepared) {
  std::vector<int32_t> cells;
  if (prepared.statistics.is_closed()) return cells;
  const EdgeCensus census = take_edge_census(prepared.vertices, prepared.triangles);
  const Pieces pieces(prepared, census);
  std::vector<bool> is_rim(prepared.vertices.size(), false);
  for (const RimEdge& edge : census.rims) {
    if (pieces.is_beside_another(edge)) continue;
    is_rim[edge.from] = is_rim[edge.to] = true;
    add_cells(prepared, pieces.grid_point(edge.from), pieces.grid_point(edge.to), cells);
  }
  for (size_t v = 0; v < is_rim.size(); ++v)
    if (is_rim[census.place[v]] && prepared.evaluation[v].cell != kNone)
      cells.push_back(prepared.evaluation[v].cell);
  std::ranges::sort(cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

bool is_closed(const PreparedMesh& prepared) {
  return take_edge_census(prepared.vertices, prepared.triangles).is_closed;
}

}  // namespace burnish
