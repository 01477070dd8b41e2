#include "server/solver/cuda/mesh/packed_restriction.h"

#include <algorithm>
#include <span>

#include "server/solver/cuda/device/packed.h"

namespace burnish::cuda {

// Returns how many halvings make a weight of 1, 1/2, 1/4 or 1/8; -1 for other weights.
static int halvings_of(float weight) {
  for (int halvings = 0; halvings < 4; ++halvings)
    if (weight == 1 / static_cast<float>(1 << halvings)) return halvings;
  return -1;
}

static void pack_row(const DepthTransfer& transfer, int64_t begin, int64_t end,
                     PackedRestriction& result) {
  for (int64_t k = begin; k < end; ++k)
    result.packed.push_back(
        pack_restriction(transfer.restriction_corner[k],
                         static_cast<uint32_t>(halvings_of(transfer.restriction_weight[k]))));
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
  PackedRestriction result;
  result.packed.reserve(transfer.restriction_corner.size());
  result.start = {0};
  result.listed_start = {0};
  std::vector<uint8_t> is_packed;
  for (size_t row = 0; row + 1 < transfer.restriction_start.size(); ++row)
    is_packed.push_back(fits(transfer, row));
  const bool lists_any = std::ranges::count(is_packed, 0) > 0;
  for (size_t row = 0; row < is_packed.size(); ++row) {
    const int64_t begin = transfer.restriction_start[row],
                  end = transfer.restriction_start[row + 1];
    const bool is_listed = is_packed[row] == 0 || (lists_any && begin == end);
    if (is_listed) result.listed.push_back(static_cast<int32_t>(row));
    (is_listed ? list_row : pack_row)(transfer, begin, end, result);
    result.start.push_back(static_cast<int64_t>(result.packed.size()));
  }
  return result;
}

}  // namespace burnish::cuda
