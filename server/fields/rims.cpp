#include "server/fields/rims.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "common/base/disjoint_sets.h"
#include "common/base/sort_once.h"
#include "common/grid/sparse_grid.h"
#include "common/grid/stencil_slots.h"
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
        piece_(census.place.size(), kNone),
        least_(prepared.cells.size(), kNone),
        most_(prepared.cells.size(), kNone) {
    find_pieces(census.place);
    for (size_t v = 0; v < piece_.size(); ++v)
      if (piece_[census.place[v]] != kNone)
        note(prepared.evaluation[v].cell, piece_[census.place[v]]);
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

  /// Vertices without a triangle belong to no piece.
  void find_pieces(const std::vector<uint32_t>& place) {
    DisjointSets sets(place.size());
    for (const Triangle& t : prepared_.triangles) {
      const auto first = static_cast<int32_t>(place[t[0]]);
      for (const uint32_t v : t) {
        if (v != t[0]) sets.join(first, static_cast<int32_t>(place[v]));
        piece_[place[v]] = first;
      }
    }
    for (int32_t& piece : piece_)
      if (piece != kNone) piece = sets.root(piece);
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

/// Returns the edges of rims that do not lie on another piece.
std::vector<RimEdge> free_rims(const EdgeCensus& census, const Pieces& pieces) {
  std::vector<RimEdge> edges;
  std::ranges::copy_if(census.rims, std::back_inserter(edges),
                       [&](const RimEdge& edge) { return !pieces.is_beside_another(edge); });
  return edges;
}

/// Removes the edges of rims that are too short to be held. Edges that meet are one rim.
void remove_short(const PreparedMesh& prepared, std::vector<RimEdge>& edges) {
  const auto length = [&](const RimEdge& edge) {
    return (prepared.vertices[edge.to] - prepared.vertices[edge.from]).norm();
  };
  DisjointSets rims(prepared.vertices.size());
  for (const RimEdge& edge : edges)
    rims.join(static_cast<int32_t>(edge.from), static_cast<int32_t>(edge.to));
  std::vector<double> sum(prepared.vertices.size(), 0);  // per root
  for (const RimEdge& edge : edges) sum[rims.root(static_cast<int32_t>(edge.from))] += length(edge);
  const double least = std::max(kHeldRimCellsMin * prepared.frame.cell_size,
                                kHeldRimDiagonalsMin * prepared.statistics.diagonal());
  std::erase_if(edges, [&](const RimEdge& edge) {
    return sum[rims.root(static_cast<int32_t>(edge.from))] < least;
  });
}

}  // namespace

std::vector<int32_t> rim_cells(const PreparedMesh& prepared) {
  std::vector<int32_t> cells;
  if (prepared.statistics.is_closed()) return cells;
  const EdgeCensus census = take_edge_census(prepared.vertices, prepared.triangles);
  const Pieces pieces(prepared, census);
  std::vector<RimEdge> edges = free_rims(census, pieces);
  remove_short(prepared, edges);
  std::vector<bool> is_rim(prepared.vertices.size(), false);
  for (const RimEdge& edge : edges) {
    is_rim[edge.from] = is_rim[edge.to] = true;
    add_cells(prepared, pieces.grid_point(edge.from), pieces.grid_point(edge.to), cells);
  }
  for (size_t v = 0; v < is_rim.size(); ++v)
    if (is_rim[census.place[v]] && prepared.evaluation[v].cell != kNone)
      cells.push_back(prepared.evaluation[v].cell);
  sort_once(cells);
  return cells;
}

uint64_t rim_cells_bytes(uint64_t vertices, uint64_t triangles, uint64_t cells, uint64_t rims) {
  constexpr uint64_t kPerVertex = 2 * sizeof(int32_t) + sizeof(double) + 1;  // pieces, rims, sums
  return edge_census_bytes(vertices, triangles, rims) + vertices * kPerVertex +
         cells * 2 * sizeof(int32_t);
}

bool is_closed(const PreparedMesh& prepared) {
  return take_edge_census(prepared.vertices, prepared.triangles).is_closed;
}

}  // namespace burnish
