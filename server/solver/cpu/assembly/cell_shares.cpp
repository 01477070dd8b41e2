#include "server/solver/cpu/assembly/cell_shares.h"

#include <algorithm>
#include <utility>

#include "common/base/dispatch.h"
#include "server/solver/hierarchy/half_way.h"

namespace burnish::cpu {

namespace {

constexpr size_t kTargetsAlone = 128;  // for fewer, waking threads takes longer

/// An 8×8 matrix by rows.
struct Square {
  Double8 row[8] = {};
};

Square square_of(const CellMatrix& cell) {
  Square k;
  for (int a = 0; a < 8; ++a) {
    double diagonal = cell.row_sum[a];
    for (int b = 0; b < 8; ++b) {
      if (b == a) continue;
      k.row[a][b] = cell.pair[pair_index(a, b)];
      diagonal -= k.row[a][b];
    }
    k.row[a][a] = diagonal;
  }
  return k;
}

Square square_of(const double* tie, bool is_transposed) {
  Square k;
  for (int v = 0; v < 8; ++v)
    for (int w = 0; w < 8; ++w) k.row[v][w] = is_transposed ? tie[8 * w + v] : tie[8 * v + w];
  return k;
}

// Finds the weights of the coarse cell's corners at corner a of a part.
void find_weights(const CellPart& part, int a, Double8& weights) {
  const auto& half_way = half_way_weights()[part.place[a]];
  for (int v = 0; v < 8; ++v) weights[v] = double{part.weight[a]} * half_way[v];
}

// sum += Lᵀ N R. Most parts have few corners.
BURNISH_DISPATCH void add_product(const CellPart& left, const Square& n, const CellPart& right,
                                  Square& sum) {
  Square nr;
  for (int b = 0; b < 8; ++b) {
    if (right.weight[b] == 0) continue;
    Double8 r;
    find_weights(right, b, r);
    for (int a = 0; a < 8; ++a) nr.row[a] += n.row[a][b] * r;
  }
  for (int a = 0; a < 8; ++a) {
    if (left.weight[a] == 0) continue;
    Double8 l;
    find_weights(left, a, l);
    for (int v = 0; v < 8; ++v) sum.row[v] += l[v] * nr.row[a];
  }
}

void add_to_cell(const Square& sum, CellMatrix& cell) {
  for (int v = 0; v < 8; ++v)
    for (int w = 0; w < 8; ++w) {
      cell.row_sum[v] += sum.row[v][w];
      if (w > v) cell.pair[pair_index(v, w)] += sum.row[v][w];
    }
}

void write_tie(const Square& sum, double* tie) {
  for (int v = 0; v < 8; ++v)
    for (int w = 0; w < 8; ++w) tie[8 * v + w] = sum.row[v][w];
}

void add_shares_of_target(const HierarchyDepth& fine, const HierarchyDepth& coarse, size_t i,
                          const CombinedCells& fine_cells, CombinedCells& coarse_cells) {
  const CellShares& shares = coarse.shares;
  const int32_t fine_count = fine.grid.cell_count(), coarse_count = coarse.grid.cell_count();
  Square sum;
  for (int32_t k = shares.start[i]; k < shares.start[i + 1]; ++k) {
    const CellShare& share = shares.share[k];
    const int32_t tie = share.source - fine_count;
    const Square of_source =
        tie < 0 ? square_of(fine_cells[share.source])
                : square_of(fine_cells.numbers() + number_of_tie(fine_count, tie, 0, 0),
                            share.is_transposed != 0);
    add_product(shares.part[share.left], of_source, shares.part[share.right], sum);
  }
  if (const int32_t target = shares.target[i]; target < coarse_count)
    add_to_cell(sum, coarse_cells[target]);
  else
    write_tie(sum,
              coarse_cells.numbers() + number_of_tie(coarse_count, target - coarse_count, 0, 0));
}

}  // namespace

void write_square(const CellMatrix& cell, double* square) {
  write_tie(square_of(cell), square);
}

void add_shares(const HierarchyDepth& fine, const HierarchyDepth& coarse,
                const CombinedCells& fine_cells, CombinedCells& coarse_cells) {
  const size_t targets = coarse.shares.target.size();
#pragma omp parallel for schedule(dynamic, 64) if (targets > kTargetsAlone)
  for (size_t i = 0; i < targets; ++i)
    add_shares_of_target(fine, coarse, i, fine_cells, coarse_cells);
}

void add_shares(const HierarchyDepth& fine, const HierarchyDepth& coarse, int32_t part,
                const CombinedCells& fine_cells, CombinedCells& coarse_cells) {
  const std::vector<int32_t>& targets = coarse.shares.target;
  const auto i = std::ranges::lower_bound(targets, part) - targets.begin();
  if (i < std::ssize(targets) && targets[i] == part)
    add_shares_of_target(fine, coarse, i, fine_cells, coarse_cells);
}

}  // namespace burnish::cpu
