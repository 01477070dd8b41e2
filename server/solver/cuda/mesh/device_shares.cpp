#include "server/solver/cuda/mesh/device_shares.h"

#include <cstddef>
#include <vector>

#include "server/solver/hierarchy/touched_blocks.h"

namespace burnish::cuda {

static_assert(offsetof(CellPart, place) == offsetof(burnish::CellPart, place));
static_assert(offsetof(CellShare, left) == offsetof(burnish::CellShare, left) &&
              offsetof(CellShare, is_transposed) == offsetof(burnish::CellShare, is_transposed));

static std::vector<int32_t> blocks_of_targets(const HierarchyDepth& depth) {
  std::vector<int32_t> blocks;
  blocks.reserve(depth.shares.target.size());
  for (const int32_t part : depth.shares.target)
    blocks.push_back(block_of_coarse_part(depth, part));
  return blocks;
}

DeviceShares::DeviceShares(Stream& stream, const HierarchyDepth& depth)
    : apart_(stream, depth.shares.apart) {
  const CellShares& shares = depth.shares;
  if (shares.target.empty()) return;
  block_ = {stream, blocks_of_targets(depth)};
  part_ = DeviceArray<CellPart>::copy_of(stream, shares.part);
  share_ = DeviceArray<CellShare>::copy_of(stream, shares.share);
  target_ = {stream, shares.target};
  start_ = {stream, shares.start};
}

Shares DeviceShares::view() const {
  return {static_cast<int32_t>(target_.size()),
          part_.data(),
          target_.data(),
          start_.data(),
          block_.data(),
          share_.data(),
          static_cast<int32_t>(apart_.size()),
          apart_.data()};
}

uint64_t DeviceShares::byte_count() const {
  return part_.byte_count() + share_.byte_count() + target_.byte_count() + start_.byte_count() +
         block_.byte_count() + apart_.byte_count();
}

}  // namespace burnish::cuda
