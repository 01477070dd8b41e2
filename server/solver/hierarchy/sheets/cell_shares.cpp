#include "server/solver/hierarchy/sheets/cell_shares.h"

#include <algorithm>
#include <tuple>

#include "common/base/select_numbers.h"
#include "common/base/sort_once.h"
#include "server/solver/hierarchy/half_way.h"

namespace burnish {

namespace {

CellPart part_of_octant(int octant) {
  CellPart part;
  part.weight.fill(1);
  for (int a = 0; a < kCornersPerCell; ++a)
    part.place[a] = place_in_parent({static_cast<MortonKey>(octant), 0}, a);
  return part;
}

int32_t octant_of(const GridKey& cell) {
  return static_cast<int32_t>(cell.place & 7);
}

// Returns the corners of the coarse cell that weigh on these corners of a part.
uint8_t weighing_on(const CellPart& part, uint8_t corners) {
  unsigned weighing = 0;
  for (int a = 0; a < kCornersPerCell; ++a) {
    if ((corners >> a & 1) == 0 || part.weight[a] == 0) continue;
    const PositiveWeights& weights = positive_weights(part.place[a]);
    for (int i = 0; i < weights.count; ++i) weighing |= 1u << weights.corner[i];
  }
  return static_cast<uint8_t>(weighing);
}

/// Collects shares by the two coarse cells that they couple. Equal cells mean a cell's own numbers.
class Collector {
 public:
  Collector() {
    for (int octant = 0; octant < 8; ++octant) part_.push_back(part_of_octant(octant));
  }

  int32_t add_part(const CellPart& part) {
    part_.push_back(part);
    return static_cast<int32_t>(part_.size()) - 1;
  }

  /// `rows` and `columns`: the corners of L's and R's side at which the source has numbers.
  void add(int32_t left_cell, int32_t right_cell, CellShare share, uint8_t rows, uint8_t columns) {
    uint8_t left = weighing_on(part_[share.left], rows);
    uint8_t right = weighing_on(part_[share.right], columns);
    if (left_cell > right_cell) {
      std::swap(left_cell, right_cell);
      std::swap(left, right);
      std::swap(share.left, share.right);
      share.is_transposed = !share.is_transposed;
    }
    summands_.push_back({left_cell, right_cell, left, right, share});
  }

  TiesAndShares collected(const SparseGrid& coarse) {
    const auto order = [](const Summand& s) {
      return std::tuple(s.first != s.second, s.first, s.second);
    };
    std::ranges::stable_sort(summands_, {}, order);
    TiesAndShares result;
    result.shares.part = std::move(part_);
    result.shares.start = {0};
    for (size_t i = 0; i < summands_.size(); ++i) {
      const Summand& s = summands_[i];
      const bool is_new = i == 0 || order(s) != order(summands_[i - 1]);
      const bool is_tie = s.first != s.second;
      if (is_new && is_tie) result.ties.push_back({s.first, s.second, 0, 0});
      if (is_new)
        result.shares.target.push_back(
            is_tie ? coarse.cell_count() + static_cast<int32_t>(result.ties.size()) - 1 : s.first);
      if (is_tie) {
        result.ties.back().first_corners |= s.rows;
        result.ties.back().second_corners |= s.columns;
      }
      result.shares.share.push_back(s.share);
      if (i + 1 == summands_.size() || order(s) != order(summands_[i + 1]))
        result.shares.start.push_back(static_cast<int32_t>(result.shares.share.size()));
    }
    return result;
  }

 private:
  struct Summand {
    int32_t first, second;
    uint8_t rows, columns;
    CellShare share;
  };

  std::vector<CellPart> part_;
  std::vector<Summand> summands_;
};

/// The parts of a cell, each of another coarse cell.
class Parts {
 public:
  explicit Parts(const CoarseGrid& coarse) : coarse_(coarse) {}

  void add(const FromCell& from, int a, float weight) {
    auto part = std::ranges::find(cells_, from.cell);
    if (part == cells_.end()) {
      cells_.push_back(from.cell);
      parts_.push_back({});
      part = cells_.end() - 1;
    }
    CellPart& to = parts_[part - cells_.begin()];
    to.weight[a] += weight;
    to.place[a] = from.place;
  }

  /// Returns whether two coarse cells give the same value at a point.
  bool are_alike(const FromCell& a, const FromCell& b) const {
    return corners_of(a) == corners_of(b);
  }

  const std::vector<int32_t>& cells() const { return cells_; }
  const std::vector<CellPart>& parts() const { return parts_; }

 private:
  // Returns the corners that weigh on a point, in the order of space.
  std::vector<int32_t> corners_of(const FromCell& from) const {
    std::vector<int32_t> corners;
    const PositiveWeights& weights = positive_weights(from.place);
    for (int i = 0; i < weights.count; ++i)
      corners.push_back(coarse_.grid.cell_corners[from.cell][weights.corner[i]]);
    return corners;
  }

  const CoarseGrid& coarse_;
  std::vector<int32_t> cells_;
  std::vector<CellPart> parts_;
};

int64_t find_shared(const SheetCorners& sheets, int32_t corner) {
  const auto at = std::ranges::lower_bound(sheets.shared, corner);
  return at != sheets.shared.end() && *at == corner ? at - sheets.shared.begin() : -1;
}

Parts parts_of(int32_t sheet, int32_t cell, const SparseGrid& finest, const SheetCorners& sheets,
               const CoarseGrid& coarse) {
  Parts parts(coarse);
  for (int a = 0; a < kCornersPerCell; ++a) {
    const bool is_of_small_component = coarse.parent_cell[sheet] == kNone;
    const FromCell own = is_of_small_component ? coarse.from[sheets.corners[sheet][a]]
                                               : FromCell{coarse.parent_cell[sheet],
                                                          place_in_parent(sheets.cell[sheet], a)};
    if (own.cell == kNone) continue;
    const int64_t shared = find_shared(sheets, finest.cell_corners[cell][a]);
    if (shared < 0) {
      parts.add(own, a, 1);
      continue;
    }
    for (int32_t k = sheets.start[shared]; k < sheets.start[shared + 1]; ++k) {
      const FromCell& other = coarse.from[sheets.copy[k]];
      parts.add(parts.are_alike(own, other) ? own : other, a, sheets.weight[k]);
    }
  }
  return parts;
}

// Returns the cells that are not a plain child of their parent: they have a shared corner, several
// sheets, or no parent.
std::vector<int32_t> cells_apart(const SparseGrid& finest, const SheetCorners& sheets,
                                 const CoarseGrid& coarse) {
  std::vector<int32_t> cells;
  for (int32_t corner : sheets.shared)
    for (int32_t cell : finest.cells_of_corner[corner])
      if (cell != kNone) cells.push_back(cell);
  const std::vector<int32_t> without_one_parent =
      select_numbers(finest.cell_count(), [&](int32_t cell) {
        return sheets.has_several(cell) || coarse.parent_cell[sheets.first_of_cell[cell]] == kNone;
      });
  cells.insert(cells.end(), without_one_parent.begin(), without_one_parent.end());
  sort_once(cells);
  return cells;
}

// Returns the cells whose parent has eight children before them.
std::vector<int32_t> cells_beyond_eight(const CoarseGrid& coarse) {
  const auto cells = static_cast<int32_t>(coarse.parent_cell.size());
  std::vector<int32_t> children(coarse.grid.cells.size());
#pragma omp parallel for schedule(static)
  for (int32_t c = 0; c < cells; ++c)
    __atomic_add_fetch(&children[coarse.parent_cell[c]], 1, __ATOMIC_RELAXED);
  std::vector<int32_t> crowded =
      select_numbers(cells, [&](int32_t c) { return children[coarse.parent_cell[c]] > 8; });
  for (const int32_t c : crowded) children[coarse.parent_cell[c]] = 0;
  std::erase_if(crowded, [&](int32_t c) { return ++children[coarse.parent_cell[c]] <= 8; });
  return crowded;
}

void share_sheet(const Parts& parts, int32_t source, Collector& collector) {
  std::vector<int32_t> number;
  for (const CellPart& part : parts.parts()) number.push_back(collector.add_part(part));
  for (size_t i = 0; i < number.size(); ++i)
    for (size_t j = i; j < number.size(); ++j)
      collector.add(parts.cells()[i], parts.cells()[j], {source, number[i], number[j], 0}, 0xff,
                    0xff);
}

}  // namespace

TiesAndShares share_cells(const SparseGrid& finest, const SheetCorners& sheets,
                          const CoarseGrid& coarse) {
  Collector collector;
  const std::vector<int32_t> apart = cells_apart(finest, sheets, coarse);
  for (int32_t cell : apart)
    for (int32_t s = sheets.first_of_cell[cell]; s < sheets.first_of_cell[cell + 1]; ++s)
      share_sheet(parts_of(s, cell, finest, sheets, coarse), sheets.source[s], collector);
  TiesAndShares result = collector.collected(coarse.grid);
  result.shares.apart = apart;
  return result;
}

TiesAndShares share_ties(const SparseGrid& fine, std::span<const CellTie> ties,
                         const CoarseGrid& coarse) {
  Collector collector;
  std::vector<int32_t> apart = cells_beyond_eight(coarse);
  for (const int32_t c : apart) {
    const int32_t parent = coarse.parent_cell[c], octant = octant_of(fine.cells[c]);
    collector.add(parent, parent, {c, octant, octant, 0}, 0xff, 0xff);
  }
  for (size_t t = 0; t < ties.size(); ++t) {
    const CellTie& tie = ties[t];
    const int32_t first = coarse.parent_cell[tie.first], second = coarse.parent_cell[tie.second];
    const CellShare share = {fine.cell_count() + static_cast<int32_t>(t),
                             octant_of(fine.cells[tie.first]), octant_of(fine.cells[tie.second]),
                             0};
    collector.add(first, second, share, tie.first_corners, tie.second_corners);
    if (first == second)
      collector.add(second, first, {share.source, share.right, share.left, 1}, tie.second_corners,
                    tie.first_corners);
  }
  TiesAndShares result = collector.collected(coarse.grid);
  result.shares.apart = std::move(apart);
  return result;
}

}  // namespace burnish
