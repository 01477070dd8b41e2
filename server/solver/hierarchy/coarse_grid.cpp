#include "server/solver/hierarchy/coarse_grid.h"

#include <algorithm>
#include <functional>

#include "common/base/check.h"
#include "common/base/disjoint_sets.h"
#include "common/base/parallel.h"
#include "common/base/resize_touched.h"
#include "common/base/select_numbers.h"
#include "server/solver/hierarchy/half_way.h"

namespace burnish {

namespace {

void raise_to(int32_t& at, int32_t value) {
  int32_t before = __atomic_load_n(&at, __ATOMIC_RELAXED);
  while (before < value && !__atomic_compare_exchange_n(&at, &before, value, true, __ATOMIC_RELAXED,
                                                        __ATOMIC_RELAXED)) {
  }
}

using CellCorners = std::array<int32_t, kCornersPerCell>;

FromCell find_parent_of_corner(const SparseGrid& fine, const std::vector<int32_t>& parent_cell,
                               int32_t corner) {
  for (int a = 0; a < kCornersPerCell; ++a) {
    const int32_t cell = fine.cells_of_corner[corner][a];
    if (cell != kNone) return {parent_cell[cell], place_in_parent(fine.cells[cell], a)};
  }
  BURNISH_CHECK(false, "every corner belongs to a cell");
}

bool have_common_corner(const GridKey& cell, const CellCorners& corners, const GridKey& other,
                        const CellCorners& other_corners) {
  for (int a = 0; a < kCornersPerCell; ++a) {
    const Vec3i at = corner_offset(a) + corner_offset(static_cast<int>(cell.place & 7)) -
                     corner_offset(static_cast<int>(other.place & 7));
    if ((at.array() < 0).any() || (at.array() > 1).any()) continue;
    if (corners[a] == other_corners[at.x() + 2 * at.y() + 4 * at.z()]) return true;
  }
  return false;
}

/// Joins the fine cells of one parent.
class Parents {
 public:
  Parents(std::span<const GridKey> cells, std::span<const CellCorners> corners)
      : cells_(cells), corners_(corners), root_(cells.size()) {
    std::vector<int32_t> group_start = select_numbers(count(), [&](int32_t c) {
      return c == 0 || cells[c].place >> 3 != cells[c - 1].place >> 3;
    });
    group_start.push_back(count());
    ParallelFailure failure;
#pragma omp parallel for schedule(dynamic, 1024)
    for (size_t g = 0; g < group_start.size() - 1; ++g) {
      const int32_t begin = group_start[g], end = group_start[g + 1];
      if (end - begin <= kPairedMax)
        join_group(begin, end);
      else
        failure.run([&] { join_crowd(begin, end); });
    }
    failure.rethrow();
  }

  /// Returns the parents, by place, then by their first child. Sets the parent of each cell.
  std::vector<GridKey> number(std::vector<int32_t>& parent_cell) const {
    const std::vector<int32_t> first =
        select_numbers(count(), [&](int32_t c) { return root_[c] == c; });
    std::vector<GridKey> parents(first.size());
    resize_touched(parent_cell, cells_.size());
#pragma omp parallel for schedule(static)
    for (size_t p = 0; p < first.size(); ++p) {
      parent_cell[first[p]] = static_cast<int32_t>(p);
      parents[p] = {cells_[first[p]].place >> 3, first[p]};
    }
#pragma omp parallel for schedule(static)
    for (int32_t c = 0; c < count(); ++c)
      if (root_[c] != c) parent_cell[c] = parent_cell[root_[c]];
    return parents;
  }

 private:
  int32_t count() const {
    return static_cast<int32_t>(cells_.size());
  }

  static constexpr int32_t kPairedMax = 32;  // children of one place compared in pairs

  // Joins cells by their corners: dust may fill a place with too many cells for pairs.
  void join_crowd(int32_t begin, int32_t end) {
    std::vector<std::pair<int32_t, int32_t>> cell_at;  // corner and cell
    for (int32_t c = begin; c < end; ++c)
      for (int32_t corner : corners_[c]) cell_at.emplace_back(corner, c - begin);
    std::ranges::sort(cell_at);
    DisjointSets joined(end - begin);
    for (size_t i = 1; i < cell_at.size(); ++i)
      if (cell_at[i].first == cell_at[i - 1].first)
        joined.join(cell_at[i].second, cell_at[i - 1].second);
    for (int32_t c = begin; c < end; ++c) root_[c] = begin + joined.root(c - begin);
  }

  // Grows the parents one after the other, each from its first child.
  void join_group(int32_t begin, int32_t end) {
    std::fill(root_.begin() + begin, root_.begin() + end, kNone);
    std::vector<int32_t> reached;
    for (int32_t first = begin; first < end; ++first) {
      if (root_[first] != kNone) continue;
      root_[first] = first;
      reached = {first};
      while (!reached.empty()) {
        const int32_t cell = reached.back();
        reached.pop_back();
        for (int32_t other = first + 1; other < end; ++other) {
          if (root_[other] != kNone ||
              !have_common_corner(cells_[cell], corners_[cell], cells_[other], corners_[other]))
            continue;
          root_[other] = first;
          reached.push_back(other);
        }
      }
    }
  }

  std::span<const GridKey> cells_;
  std::span<const CellCorners> corners_;
  std::vector<int32_t> root_;  // the first child of the same parent
};

// Finds every corner's place in the parent of its last cell.
void find_places_of_corners(std::span<const GridKey> cells,
                            std::span<const CellCorners> cell_corners, CoarseGrid& coarse) {
  std::vector<int32_t> last(coarse.from.size(), kNone);
#pragma omp parallel for schedule(static)
  for (size_t c = 0; c < cells.size(); ++c)
    for (const int32_t corner : cell_corners[c]) raise_to(last[corner], static_cast<int32_t>(c));
#pragma omp parallel for schedule(static)
  for (size_t c = 0; c < cells.size(); ++c)
    for (int a = 0; a < kCornersPerCell; ++a)
      if (const int32_t corner = cell_corners[c][a]; last[corner] == static_cast<int32_t>(c))
        coarse.from[corner] = {coarse.parent_cell[c], place_in_parent(cells[c], a)};
}

// Joins the corners of coarse cells that meet in a fine corner. Each coarse cell has eight numbers.
DisjointSets join_corners(std::span<const GridKey> cells, std::span<const CellCorners> cell_corners,
                          const CoarseGrid& coarse) {
  DisjointSets joined(kCornersPerCell * coarse.grid.cells.size());
#pragma omp parallel for schedule(static)
  for (size_t c = 0; c < cells.size(); ++c)
    for (int a = 0; a < kCornersPerCell; ++a) {
      const FromCell here = {coarse.parent_cell[c], place_in_parent(cells[c], a)};
      const FromCell& last = coarse.from[cell_corners[c][a]];
      if (last.cell == here.cell) continue;
      // Both are the same points in space, in the same order.
      const PositiveWeights& of_last = positive_weights(last.place);
      const PositiveWeights& of_here = positive_weights(here.place);
      for (int i = 0; i < of_here.count; ++i)
        joined.join(kCornersPerCell * last.cell + of_last.corner[i],
                    kCornersPerCell * here.cell + of_here.corner[i]);
    }
  return joined;
}

// Numbers the joined corners by place, then by root.
void number_corners(DisjointSets& joined, SparseGrid& grid) {
  const int32_t nodes = kCornersPerCell * grid.cell_count();
  const std::vector<int32_t> roots =
      select_numbers(nodes, [&](int32_t node) { return joined.root(node) == node; });
  resize_touched(grid.corners, roots.size());
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < roots.size(); ++i)
    grid.corners[i] = {morton_key(morton_point(grid.cells[roots[i] / kCornersPerCell].place) +
                                  corner_offset(roots[i] % kCornersPerCell)),
                       roots[i]};
  parallel_sort(grid.corners.begin(), grid.corners.end(), std::less<>());
  std::vector<int32_t> index;
  resize_touched(index, nodes);
#pragma omp parallel for schedule(static)
  for (int32_t i = 0; i < grid.corner_count(); ++i) index[grid.corners[i].component] = i;
  resize_touched(grid.cell_corners, grid.cells.size());
#pragma omp parallel for schedule(static)
  for (int32_t c = 0; c < grid.cell_count(); ++c)
    for (int a = 0; a < kCornersPerCell; ++a)
      grid.cell_corners[c][a] = index[joined.root(kCornersPerCell * c + a)];
}

void find_cells_of_corners(SparseGrid& grid) {
  clear_cells_of_corners(grid);
  std::vector<uint8_t> is_crowded(grid.corners.size());
#pragma omp parallel for schedule(static)
  for (int32_t c = 0; c < grid.cell_count(); ++c)
    for (int a = 0; a < kCornersPerCell; ++a) {
      const int32_t corner = grid.cell_corners[c][a];
      int32_t& at = grid.cells_of_corner[corner][a];
      if (__atomic_exchange_n(&at, c, __ATOMIC_RELAXED) != kNone)
        __atomic_store_n(&is_crowded[corner], uint8_t{1}, __ATOMIC_RELAXED);
    }
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < is_crowded.size(); ++i)
    if (is_crowded[i] != 0) grid.cells_of_corner[i].fill(kNone);
}

}  // namespace

CoarseGrid join_sheets(const SparseGrid& fine) {
  CoarseGrid coarse;
  coarse.grid = make_parent_grid(fine);
  resize_touched(coarse.parent_cell, fine.cells.size());
  resize_touched(coarse.from, fine.corners.size());
#pragma omp parallel for schedule(static)
  for (int32_t c = 0; c < fine.cell_count(); ++c)
    coarse.parent_cell[c] = find_key(coarse.grid.cells, parent_key(fine.cells[c]));
#pragma omp parallel for schedule(static)
  for (int32_t i = 0; i < fine.corner_count(); ++i)
    coarse.from[i] = find_parent_of_corner(fine, coarse.parent_cell, i);
  return coarse;
}

CoarseGrid keep_sheets_apart(int depth, std::span<const GridKey> cells,
                             std::span<const CellCorners> cell_corners, int32_t corner_count) {
  CoarseGrid coarse;
  coarse.grid.depth = depth;
  coarse.grid.cells = Parents(cells, cell_corners).number(coarse.parent_cell);
  coarse.from.assign(corner_count, {kNone, 0});
  find_places_of_corners(cells, cell_corners, coarse);
  DisjointSets joined = join_corners(cells, cell_corners, coarse);
  number_corners(joined, coarse.grid);
  find_cells_of_corners(coarse.grid);
  return coarse;
}

}  // namespace burnish
