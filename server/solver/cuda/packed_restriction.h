#pragma once

#include <cstdint>
#include <vector>

#include "server/solver/depth_transfer.h"

namespace burnish::cuda {

/// A restriction as coarse corners gather it: packed what can be, in the order given, beside it the
/// rest, which are shared corners and what a row has beyond kRestrictionMax.
struct PackedRestriction {
  std::vector<int64_t> start;  ///< coarse corners + 1
  std::vector<uint32_t> packed;
  std::vector<int32_t> rest_start;  ///< likewise; empty where there is no rest, as the next two
  std::vector<int32_t> rest_corner;
  std::vector<float> rest_weight;
};
PackedRestriction pack_restriction(const DepthTransfer& transfer);

}  // namespace burnish::cuda
