#include "server/solver/cuda/packed_restriction.h"

#include "server/solver/cuda/packed.h"

namespace burnish::cuda {

// By how many halvings a weight is 1, 1/2, 1/4 or 1/8, else -1.
static int halvings_of(float weight) {
  for (int halvings = 0; halvings < 4; ++halvings)
    if (weight == 1 / static_cast<float>(1 << halvings)) return halvings;
  return -1;
}

PackedRestriction pack_restriction(const DepthTransfer& transfer) {
  PackedRestriction result;
  result.packed.reserve(transfer.restriction_corner.size());
  for (size_t row = 0; row < transfer.restriction_start.size(); ++row) {
    result.start.push_back(static_cast<int64_t>(result.packed.size()));
    result.rest_start.push_back(static_cast<int32_t>(result.rest_corner.size()));
    if (row + 1 == transfer.restriction_start.size()) break;
    int room = kRestrictionMax;
    for (auto k = transfer.restriction_start[row]; k < transfer.restriction_start[row + 1]; ++k) {
      const int halvings = halvings_of(transfer.restriction_weight[k]);
      if (halvings >= 0 && room-- > 0) {
        result.packed.push_back(
            pack_restriction(transfer.restriction_corner[k], static_cast<uint32_t>(halvings)));
      } else {
        result.rest_corner.push_back(transfer.restriction_corner[k]);
        result.rest_weight.push_back(transfer.restriction_weight[k]);
      }
    }
  }
  if (result.rest_corner.empty()) result.rest_start.clear();
  return result;
}

}  // namespace burnish::cuda
