#include "server/solver/cuda/mesh/device_shares.h"

#include <cstddef>

namespace burnish::cuda {

static_assert(offsetof(CellPart, place) == offsetof(burnish::CellPart, place));
static_assert(offsetof(CellShare, left) == offsetof(burnish::CellShare, left) &&
              offsetof(CellShare, is_transposed) == offsetof(burnish::CellShare, is_transposed));

DeviceShares::DeviceShares(Stream& stream, const CellShares& shares)
    : apart_(stream, shares.apart) {
  if (shares.target.empty()) return;
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
          share_.data(),
          static_cast<int32_t>(apart_.size()),
          apart_.data()};
}

uint64_t DeviceShares::byte_count() const {
  return part_.byte_count() + share_.byte_count() + target_.byte_count() + start_.byte_count() +
         apart_.byte_count();
}

}  // namespace burnish::cuda
