#pragma once

#include <cstdint>
#include <vector>

#include "server/solver/hierarchy/depth_transfer.h"

namespace burnish::cuda {

/// A restriction in the form that coarse corners gather. A row is packed in its order. A row with
/// more than kRestrictionMax fine corners or a shared corner is listed as a whole: a shared
/// corner's weight cannot be packed. If any row is listed, so are empty rows, which coarse corners
/// of other shards have: an empty packed row then always means a listed one.
struct PackedRestriction {
  std::vector<int64_t> start;  ///< coarse corners + 1; listed rows are empty
  std::vector<uint32_t> packed;
  std::vector<int32_t> listed;        ///< coarse corners, rising
  std::vector<int32_t> listed_start;  ///< listed + 1
  std::vector<int32_t> listed_from;
  std::vector<float> listed_weight;
};
PackedRestriction pack_restriction(const DepthTransfer& transfer);

}  // namespace burnish::cuda
