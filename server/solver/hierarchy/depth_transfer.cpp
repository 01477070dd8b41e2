#include "server/solver/hierarchy/depth_transfer.h"

#include <map>
#include <numeric>
#include <span>
#include <utility>

#include "common/base/resize_touched.h"
#include "common/base/select_numbers.h"
#include "server/solver/hierarchy/half_way.h"

namespace burnish {

namespace {

// Calls visit(fine corner, coarse corner, weight) for every entry of P, from several threads.
template <typename Visit>
void for_each_entry(const SparseGrid& coarse, int32_t fine_corners, const DepthTransfer& transfer,
                    Visit&& visit) {
#pragma omp parallel for schedule(static)
  for (int32_t fine = 0; fine < fine_corners; ++fine) {
    if (transfer.is_shared(fine)) continue;
    const FromCell from = transfer.prolongation[fine];
    const PositiveWeights& weights = positive_weights(from.place);
    for (int i = 0; i < weights.count; ++i)
      visit(fine, coarse.cell_corners[from.cell][weights.corner[i]], weights.weight[i]);
  }
  const DepthTransfer::SharedCorners& shared = transfer.shared;
#pragma omp parallel for schedule(static)
  for (int32_t s = 0; s < shared.count(); ++s)
    for (int32_t k = shared.start[s]; k < shared.start[s + 1]; ++k)
      visit(shared.corner[s], shared.coarse_corner[k], shared.weight[k]);
}

// Sorts a row of Pᵀ by fine corner, in place (Shell's sort). Its entries are nearly in order.
void sort_row(std::span<int32_t> corner, std::span<float> weight) {
  constexpr size_t kShort = 64;
  for (size_t gap = corner.size() > kShort ? corner.size() / 2 : 1; gap > 0; gap /= 2)
    for (size_t i = gap; i < corner.size(); ++i)
      for (size_t to = i; to >= gap && corner[to - gap] > corner[to]; to -= gap) {
        std::swap(corner[to - gap], corner[to]);
        std::swap(weight[to - gap], weight[to]);
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

std::vector<FromCell> first_of(const std::vector<FromCell>& from, size_t count) {
  std::vector<FromCell> first;
  resize_touched(first, count);
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < count; ++i) first[i] = from[i];
  return first;
}

}  // namespace

// Makes Pᵀ by rows: counts the entries of P by coarse corner, puts them there in any order, and
// sorts each row.
void make_restriction(const SparseGrid& coarse, int32_t fine_corners, DepthTransfer& transfer) {
  std::vector<int64_t>& start = transfer.restriction_start;
  start.assign(coarse.corner_count() + 1, 0);
  for_each_entry(coarse, fine_corners, transfer, [&](int32_t, int32_t to, float) {
    __atomic_add_fetch(&start[to + 1], 1, __ATOMIC_RELAXED);
  });
  std::partial_sum(start.begin(), start.end(), start.begin());
  resize_touched(transfer.restriction_corner, start.back());
  resize_touched(transfer.restriction_weight, start.back());
  std::vector<int64_t> next(start.begin(), start.end() - 1);
  for_each_entry(coarse, fine_corners, transfer, [&](int32_t fine, int32_t to, float weight) {
    const int64_t at = __atomic_fetch_add(&next[to], 1, __ATOMIC_RELAXED);
    transfer.restriction_corner[at] = fine;
    transfer.restriction_weight[at] = weight;
  });
#pragma omp parallel for schedule(static)
  for (int32_t to = 0; to < coarse.corner_count(); ++to)
    sort_row(std::span(transfer.restriction_corner).subspan(start[to], start[to + 1] - start[to]),
             std::span(transfer.restriction_weight).subspan(start[to], start[to + 1] - start[to]));
}

static void make_restriction(const SparseGrid& coarse, DepthTransfer& transfer) {
  make_restriction(coarse, static_cast<int32_t>(transfer.prolongation.size()), transfer);
}

DepthTransfer make_transfer(const CoarseGrid& coarse) {
  DepthTransfer transfer;
  transfer.prolongation = first_of(coarse.from, coarse.from.size());
  transfer.shared.start = {0};
  make_restriction(coarse.grid, transfer);
  return transfer;
}

DepthTransfer make_transfer(const CoarseGrid& coarse, const SheetCorners& sheets,
                            int32_t corner_count) {
  DepthTransfer transfer;
  transfer.prolongation = first_of(coarse.from, corner_count);
  for (const int32_t corner : sheets.shared) transfer.prolongation[corner] = {kNone, 0};
  DepthTransfer::SharedCorners& shared = transfer.shared;
  shared.corner =
      select_numbers(corner_count, [&](int32_t corner) { return transfer.is_shared(corner); });
  shared.start = {0};
  size_t next = 0;
  for (const int32_t corner : shared.corner) {
    if (next < sheets.shared.size() && sheets.shared[next] == corner)
      add_shared(coarse, sheets, next++, transfer);
    shared.start.push_back(static_cast<int32_t>(shared.coarse_corner.size()));
  }
  make_restriction(coarse.grid, transfer);
  return transfer;
}

}  // namespace burnish
