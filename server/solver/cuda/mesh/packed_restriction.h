#pragma once

#include <cstdint>
#include <vector>

#include "server/solver/hierarchy/depth_transfer.h"

namespace burnish::cuda {

/// A restriction as coarse corners gather it. A row is packed in the order given, or listed as a
/// whole: where it has more than kRestrictionMax fine corners or a shared one, whose weight is none
/// of those that can be packed.
struct PackedRestriction {
  std::vector<int64_t> start;  ///< coarse corners + 1; nothing of listed rows
  std::vector<uint32_t> packed;
  std::vector<int32_t> listed;        ///< coarse corners, rising
  std::vector<int32_t> listed_start;  ///< these + 1
  std::vector<int32_t> listed_from;
  std::vector<float> listed_weight;
};
PackedRestriction pack_restriction(const DepthTransfer& transfer);

}  // namespace burnish::cuda
