#include "server/solver/hierarchy/sheets/irregular_rows.h"

#include "common/base/select_numbers.h"
#include "server/solver/hierarchy/cell_matrix.h"

namespace burnish {

namespace {

/// A number that is part of the entry in `column`, or of the row sum if `column` is kRowSum.
struct Source {
  static constexpr int32_t kRowSum = INT32_MAX;
  int32_t column;
  int32_t number;
};

/// The sources of every irregular row.
class Sources {
 public:
  Sources(const SparseGrid& grid, std::span<const uint32_t> mask)
      : grid_(grid), row_of_corner_(mask.size(), kNone) {
    corners_ =
        select_numbers(grid.corner_count(), [&](int32_t corner) { return mask[corner] == 0; });
    for (size_t i = 0; i < corners_.size(); ++i)
      row_of_corner_[corners_[i]] = static_cast<int32_t>(i);
    rows_.resize(corners_.size());
  }

  void add_cell(int32_t cell) {
    const auto& corners = grid_.cell_corners[cell];
    for (int a = 0; a < kCornersPerCell; ++a) {
      if (row_of_corner_[corners[a]] == kNone) continue;
      auto& row = rows_[row_of_corner_[corners[a]]];
      for (int b = 0; b < kCornersPerCell; ++b)
        if (b != a) row.push_back({corners[b], number_of_cell(cell, pair_index(a, b))});
      row.push_back({Source::kRowSum, number_of_cell(cell, kPairsPerCell + a)});
    }
  }

  void add_tie(const CellTie& tie, int32_t number) {
    for (int v = 0; v < kCornersPerCell; ++v)
      for (int w = 0; w < kCornersPerCell; ++w) {
        if ((tie.first_corners >> v & tie.second_corners >> w & 1) == 0) continue;
        const int32_t first = grid_.cell_corners[tie.first][v];
        const int32_t second = grid_.cell_corners[tie.second][w];
        const int32_t source = number_of_tie(grid_.cell_count(), number, v, w);
        add_coupling(first, second, source);
        add_coupling(second, first, source);
      }
  }

  std::vector<int32_t> corners() const { return corners_; }
  /// By column; sources of one column stay in the order in which they were added.
  const std::vector<Source>& sorted_row(size_t i) {
    std::ranges::stable_sort(rows_[i], {}, &Source::column);
    return rows_[i];
  }

 private:
  void add_coupling(int32_t corner, int32_t column, int32_t source) {
    auto& row = rows_[row_of_corner_[corner]];
    if (column != corner) row.push_back({column, source});
    row.push_back({Source::kRowSum, source});
  }

  const SparseGrid& grid_;
  std::vector<int32_t> row_of_corner_;  // kNone for regular corners
  std::vector<int32_t> corners_;
  std::vector<std::vector<Source>> rows_;
};

}  // namespace

IrregularRows find_irregular_rows(const SparseGrid& grid, std::span<const CellTie> ties,
                                  std::span<const uint32_t> mask, IrregularColumns& columns) {
  IrregularRows rows;
  Sources sources(grid, mask);
  rows.corner = sources.corners();
  rows.sum_start = {0};
  rows.source_start = {0};
  columns.start = {0};
  if (rows.corner.empty()) return rows;
  const std::vector<int32_t> cells = select_numbers(grid.cell_count(), [&](int32_t cell) {
    return std::ranges::any_of(grid.cell_corners[cell],
                               [&](int32_t corner) { return mask[corner] == 0; });
  });
  for (const int32_t cell : cells) sources.add_cell(cell);
  for (size_t t = 0; t < ties.size(); ++t) sources.add_tie(ties[t], static_cast<int32_t>(t));
  for (size_t i = 0; i < rows.corner.size(); ++i) {
    const std::vector<Source>& row = sources.sorted_row(i);
    for (size_t k = 0; k < row.size(); ++k) {
      rows.source.push_back(row[k].number);
      if (k + 1 < row.size() && row[k + 1].column == row[k].column) continue;
      rows.source_start.push_back(static_cast<int64_t>(rows.source.size()));
      if (row[k].column != Source::kRowSum) columns.column.push_back(row[k].column);
    }
    columns.start.push_back(static_cast<int64_t>(columns.column.size()));
    rows.sum_start.push_back(static_cast<int64_t>(rows.source_start.size()) - 1);
  }
  return rows;
}

}  // namespace burnish
