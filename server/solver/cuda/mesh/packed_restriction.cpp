#include "server/solver/cuda/mesh/packed_restriction.h"

#include <algorithm>
#include <span>

#include "common/base/resize_touched.h"
#include "server/solver/cuda/device/packed.h"

namespace burnish::cuda {

// Returns how many halvings make a weight of 1, 1/2, 1/4 or 1/8; -1 for other weights.
static int halvings_of(float weight) {
  for (int halvings = 0; halvings < 4; ++halvings)
    if (weight == 1 / static_cast<float>(1 << halvings)) return halvings;
  return -1;
}

static void pack_row(const DepthTransfer& transfer, int64_t begin, int64_t end, uint32_t* to) {
  for (int64_t k = begin; k < end; ++k)
    *to++ = pack_restriction(transfer.restriction_corner[k],
                             static_cast<uint32_t>(halvings_of(transfer.restriction_weight[k])));
}

static void list_row(const DepthTransfer& transfer, int64_t begin, int64_t end,
                     PackedRestriction& result) {
  result.listed_from.insert(result.listed_from.end(), transfer.restriction_corner.begin() + begin,
                            transfer.restriction_corner.begin() + end);
  result.listed_weight.insert(result.listed_weight.end(),
                              transfer.restriction_weight.begin() + begin,
                              transfer.restriction_weight.begin() + end);
  result.listed_start.push_back(static_cast<int32_t>(result.listed_from.size()));
}

static bool fits(const DepthTransfer& transfer, size_t row) {
  const auto weights =
      std::span(transfer.restriction_weight)
          .subspan(transfer.restriction_start[row])
          .first(transfer.restriction_start[row + 1] - transfer.restriction_start[row]);
  return weights.size() <= kRestrictionMax &&
         std::ranges::all_of(weights, [](float weight) { return halvings_of(weight) >= 0; });
}

PackedRestriction pack_restriction(const DepthTransfer& transfer) {
  const std::vector<int64_t>& start = transfer.restriction_start;
  const size_t rows = start.empty() ? 0 : start.size() - 1;
  std::vector<uint8_t> is_packed(rows);
#pragma omp parallel for schedule(static)
  for (size_t row = 0; row < rows; ++row) is_packed[row] = fits(transfer, row);
  const bool lists_any = std::ranges::count(is_packed, 0) > 0;
  PackedRestriction result;
  result.start = {0};
  result.start.reserve(rows + 1);
  result.listed_start = {0};
  for (size_t row = 0; row < rows; ++row) {
    const bool is_listed = is_packed[row] == 0 || (lists_any && start[row] == start[row + 1]);
    if (is_listed) {
      is_packed[row] = 0;
      result.listed.push_back(static_cast<int32_t>(row));
      list_row(transfer, start[row], start[row + 1], result);
    }
    result.start.push_back(result.start.back() + (is_listed ? 0 : start[row + 1] - start[row]));
  }
  resize_touched(result.packed, result.start.back());
#pragma omp parallel for schedule(static)
  for (size_t row = 0; row < rows; ++row)
    if (is_packed[row] != 0)
      pack_row(transfer, start[row], start[row + 1], result.packed.data() + result.start[row]);
  return result;
}

}  // namespace burnish::cuda
