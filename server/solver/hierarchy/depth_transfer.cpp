#include "server/solver/hierarchy/depth_transfer.h"

#include <map>

#include "server/solver/hierarchy/half_way.h"

namespace burnish {

namespace {

// Calls visit(fine corner, coarse corner, weight) for every entry of P, by fine corners.
template <typename Visit>
void for_each_entry(const SparseGrid& coarse, int32_t fine_corners, const DepthTransfer& transfer,
                    Visit&& visit) {
  const DepthTransfer::SharedCorners& shared = transfer.shared;
  int32_t next_shared = 0;
  for (int32_t fine = 0; fine < fine_corners; ++fine) {
    if (transfer.is_shared(fine)) {
      for (int32_t k = shared.start[next_shared]; k < shared.start[next_shared + 1]; ++k)
        visit(fine, shared.coarse_corner[k], shared.weight[k]);
      ++next_shared;
      continue;
    }
    const FromCell from = transfer.prolongation[fine];
    const PositiveWeights& weights = positive_weights(from.place);
    for (int i = 0; i < weights.count; ++i)
      visit(fine, coarse.cell_corners[from.cell][weights.corner[i]], weights.weight[i]);
  }
}

// Adds the mean of the values of a shared corner's copies.
void add_shared(const CoarseGrid& coarse, const SheetCorners& sheets, size_t i,
                DepthTransfer& transfer) {
  std::map<int32_t, double> weight;
  for (int32_t k = sheets.start[i]; k < sheets.start[i + 1]; ++k) {
    const FromCell& from = coarse.from[sheets.copy[k]];
    if (from.cell == kNone) continue;
    const PositiveWeights& half_way = positive_weights(from.place);
    for (int j = 0; j < half_way.count; ++j)
      weight[coarse.grid.cell_corners[from.cell][half_way.corner[j]]] +=
          double{sheets.weight[k]} * half_way.weight[j];
  }
  DepthTransfer::SharedCorners& shared = transfer.shared;
  for (const auto& [coarse_corner, sum] : weight) {
    shared.coarse_corner.push_back(coarse_corner);
    shared.weight.push_back(static_cast<float>(sum));
  }
}

}  // namespace

// Makes Pᵀ by rows: a counting sort of the entries of P by coarse corner.
void make_restriction(const SparseGrid& coarse, int32_t fine_corners, DepthTransfer& transfer) {
  transfer.restriction_start.assign(coarse.corner_count() + 1, 0);
  for_each_entry(coarse, fine_corners, transfer,
                 [&](int32_t, int32_t to, float) { ++transfer.restriction_start[to + 1]; });
  for (int32_t i = 0; i < coarse.corner_count(); ++i)
    transfer.restriction_start[i + 1] += transfer.restriction_start[i];
  transfer.restriction_corner.resize(transfer.restriction_start.back());
  transfer.restriction_weight.resize(transfer.restriction_start.back());
  std::vector<int64_t> next(transfer.restriction_start.begin(),
                            transfer.restriction_start.end() - 1);
  for_each_entry(coarse, fine_corners, transfer, [&](int32_t fine, int32_t to, float weight) {
    transfer.restriction_corner[next[to]] = fine;
    transfer.restriction_weight[next[to]++] = weight;
  });
}

static void make_restriction(const SparseGrid& coarse, DepthTransfer& transfer) {
  make_restriction(coarse, static_cast<int32_t>(transfer.prolongation.size()), transfer);
}

DepthTransfer make_transfer(const CoarseGrid& coarse) {
  DepthTransfer transfer;
  transfer.prolongation = coarse.from;
  transfer.shared.start = {0};
  make_restriction(coarse.grid, transfer);
  return transfer;
}

DepthTransfer make_transfer(const CoarseGrid& coarse, const SheetCorners& sheets,
                            int32_t corner_count) {
  DepthTransfer transfer;
  transfer.prolongation.assign(coarse.from.begin(), coarse.from.begin() + corner_count);
  transfer.shared.start = {0};
  DepthTransfer::SharedCorners& shared = transfer.shared;
  size_t next = 0;
  for (int32_t corner = 0; corner < corner_count; ++corner) {
    const bool is_shared = next < sheets.shared.size() && sheets.shared[next] == corner;
    if (is_shared) {
      transfer.prolongation[corner] = {kNone, 0};
      add_shared(coarse, sheets, next++, transfer);
    }
    if (!transfer.is_shared(corner)) continue;
    shared.corner.push_back(corner);
    shared.start.push_back(static_cast<int32_t>(shared.coarse_corner.size()));
  }
  make_restriction(coarse.grid, transfer);
  return transfer;
}

}  // namespace burnish
