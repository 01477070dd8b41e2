#include "server/solver/multi/shard_depth.h"

#include <algorithm>

#include "common/base/resize_touched.h"
#include "common/base/select_numbers.h"
#include "server/solver/hierarchy/sources.h"

namespace burnish {

namespace {

std::span<const int32_t> cells_of(const DepthSets& sets) {
  return std::span(sets.parts).first(sets.cells);
}

SparseGrid take_grid(const SparseGrid& whole, const DepthSets& sets, const LocalIndices& local) {
  SparseGrid grid;
  grid.depth = whole.depth;
  const auto map = [](const std::array<int32_t, kCornersPerCell>& from,
                      const std::vector<int32_t>& to) {
    std::array<int32_t, kCornersPerCell> mapped;
    for (int a = 0; a < kCornersPerCell; ++a) mapped[a] = from[a] == kNone ? kNone : to[from[a]];
    return mapped;
  };
  const std::span<const int32_t> cells = cells_of(sets);
  resize_touched(grid.cells, cells.size());
  resize_touched(grid.cell_corners, cells.size());
#pragma omp parallel for schedule(static)
  for (size_t c = 0; c < cells.size(); ++c) {
    grid.cells[c] = whole.cells[cells[c]];
    grid.cell_corners[c] = map(whole.cell_corners[cells[c]], local.corner);
  }
  resize_touched(grid.corners, sets.corners.size());
  resize_touched(grid.cells_of_corner, sets.corners.size());
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < sets.corners.size(); ++i) {
    grid.corners[i] = whole.corners[sets.corners[i]];
    grid.cells_of_corner[i] = map(whole.cells_of_corner[sets.corners[i]], local.part);
  }
  return grid;
}

std::vector<CellTie> take_ties(const HierarchyDepth& whole, const DepthSets& sets,
                               const LocalIndices& local) {
  std::vector<CellTie> ties;
  if (whole.is_finest()) return ties;
  for (const int32_t part : std::span(sets.parts).subspan(sets.cells)) {
    CellTie tie = whole.ties[part - whole.grid.cell_count()];
    tie.first = local.part[tie.first];
    tie.second = local.part[tie.second];
    ties.push_back(tie);
  }
  return ties;
}

void take_transfer(const HierarchyDepth& whole, const DepthSets& sets, const LocalIndices& local,
                   const LocalIndices& coarse, const SparseGrid& coarse_grid,
                   HierarchyDepth& made) {
  const DepthTransfer& from = whole.to_parent;
  DepthTransfer& to = made.to_parent;
  to.shared.start = {0};
  resize_touched(to.prolongation, sets.corners.size());
#pragma omp parallel for schedule(static)
  for (int32_t i = 0; i < static_cast<int32_t>(sets.corners.size()); ++i) {
    const FromCell of = i < sets.own ? from.prolongation[sets.corners[i]] : FromCell{kNone, 0};
    to.prolongation[i] =
        of.cell == kNone ? FromCell{kNone, 0} : FromCell{coarse.part[of.cell], of.place};
  }
  for (int32_t s = 0; s < from.shared.count(); ++s) {
    const int32_t corner = local.corner[from.shared.corner[s]];
    if (corner == kNone || corner >= sets.own) continue;
    to.shared.corner.push_back(corner);
    for (int32_t k = from.shared.start[s]; k < from.shared.start[s + 1]; ++k) {
      to.shared.coarse_corner.push_back(coarse.corner[from.shared.coarse_corner[k]]);
      to.shared.weight.push_back(from.shared.weight[k]);
    }
    to.shared.start.push_back(static_cast<int32_t>(to.shared.coarse_corner.size()));
  }
  make_restriction(coarse_grid, sets.own, to);
  resize_touched(made.parent_cell, sets.cells);
#pragma omp parallel for schedule(static)
  for (int32_t cell = 0; cell < sets.cells; ++cell) {
    const int32_t parent = whole.parent_cell[sets.parts[cell]];
    made.parent_cell[cell] = parent == kNone ? kNone : coarse.part[parent];
  }
}

/// Copies the parts of cells that shares use, each once. The octants' parts stay the first eight.
class UsedParts {
 public:
  UsedParts(const std::vector<CellPart>& from, std::vector<CellPart>& to)
      : from_(from), to_(to), place_(from.size(), kNone) {
    for (int32_t octant = 0; octant < std::min<int32_t>(8, std::ssize(from)); ++octant)
      take(octant);
  }
  int32_t take(int32_t part) {
    if (place_[part] == kNone) {
      place_[part] = static_cast<int32_t>(to_.size());
      to_.push_back(from_[part]);
    }
    return place_[part];
  }

 private:
  const std::vector<CellPart>& from_;
  std::vector<CellPart>& to_;
  std::vector<int32_t> place_;
};

CellShares take_shares(const HierarchyDepth& whole, const DepthSets& sets,
                       const LocalIndices& local, const NeighbourDepth& fine) {
  CellShares shares;
  shares.start = {0};
  if (!whole.shares.target.empty()) {
    UsedParts used(whole.shares.part, shares.part);
    for (size_t t = 0; t < whole.shares.target.size(); ++t) {
      const int32_t target = local.part[whole.shares.target[t]];
      if (target == kNone || sets.is_made[target] == 0) continue;
      shares.target.push_back(target);
      for (int32_t k = whole.shares.start[t]; k < whole.shares.start[t + 1]; ++k) {
        const CellShare& share = whole.shares.share[k];
        const int32_t left = used.take(share.left), right = used.take(share.right);
        shares.share.push_back({fine.local.part[share.source], left, right, share.is_transposed});
      }
      shares.start.push_back(static_cast<int32_t>(shares.share.size()));
    }
  }
  return shares;
}

void take_sources(const HierarchyDepth& whole, const DepthSets& sets, const LocalIndices& local,
                  const NeighbourDepth& fine, HierarchyDepth& made) {
  const auto children_of = [&](int32_t cell) {
    return sets.is_made[cell] != 0 ? whole.children[sets.parts[cell]] : std::span<const int32_t>();
  };
  std::vector<int32_t>& start = made.children.start;
  for (int32_t cell = 0; cell < sets.cells; ++cell)
    start.push_back(start.back() + static_cast<int32_t>(children_of(cell).size()));
  resize_touched(made.children.item, start.back());
  std::vector<uint8_t> is_child(fine.sets.cells, 0);
#pragma omp parallel for schedule(static)
  for (int32_t cell = 0; cell < sets.cells; ++cell) {
    int32_t* next = made.children.item.data() + start[cell];
    for (const int32_t child : children_of(cell)) is_child[*next++ = fine.local.part[child]] = 1;
  }
  made.shares = take_shares(whole, sets, local, fine);
  made.shares.apart =
      select_numbers(fine.sets.cells, [&](int32_t cell) { return is_child[cell] == 0; });
}

void add_stencil(HierarchyDepth& depth) {
  depth.stencil = make_stencil(depth.grid, depth.ties);
  for (const int32_t corner : depth.stencil.irregular.corner)
    depth.grid.cells_of_corner[corner].fill(kNone);
}

}  // namespace

LocalIndices::LocalIndices(const HierarchyDepth& whole, const DepthSets& sets)
    : corner(whole.grid.corners.size(), kNone), part(part_count(whole), kNone) {
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < sets.corners.size(); ++i)
    corner[sets.corners[i]] = static_cast<int32_t>(i);
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < sets.parts.size(); ++i) part[sets.parts[i]] = static_cast<int32_t>(i);
}

HierarchyDepth make_shard_depth(const NeighbourDepth& depth, const NeighbourDepth* coarse,
                                const SparseGrid* coarse_grid, const NeighbourDepth* fine) {
  const auto& [whole, sets, local] = depth;
  HierarchyDepth made;
  made.grid = take_grid(whole.grid, sets, local);
  made.ties = take_ties(whole, sets, local);
  if (fine == nullptr) made.sheet_count = static_cast<int32_t>(sets.parts.size()) - sets.cells;
  made.ghost_count = sets.ghosts;
  made.fringe_count = static_cast<int32_t>(sets.corners.size()) - sets.own - sets.ghosts;
  if (fine != nullptr) take_sources(whole, sets, local, *fine, made);
  if (coarse != nullptr) take_transfer(whole, sets, local, coarse->local, *coarse_grid, made);
  if (coarse != nullptr || sets.own > 0) add_stencil(made);
  return made;
}

}  // namespace burnish
