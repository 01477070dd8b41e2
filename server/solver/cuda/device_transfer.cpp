#include "server/solver/cuda/device_transfer.h"

#include <cstddef>

#include "server/solver/cuda/packed_restriction.h"

namespace burnish::cuda {

static_assert(offsetof(FromCell, place) == offsetof(DepthTransfer::FromCell, place));

DeviceTransfer::DeviceTransfer(Stream& stream, const DepthTransfer& transfer) {
  if (transfer.prolongation.empty()) return;
  prolongation_ = DeviceArray<FromCell>::copy_of(stream, transfer.prolongation);
  const PackedRestriction restriction = pack_restriction(transfer);
  restriction_start_ = {stream, restriction.start};
  restriction_ = {stream, restriction.packed};
  rest_start_ = {stream, restriction.rest_start};
  rest_corner_ = {stream, restriction.rest_corner};
  rest_weight_ = {stream, restriction.rest_weight};
  if (transfer.shared.count() == 0) return;
  shared_ = {stream, transfer.shared.corner};
  shared_start_ = {stream, transfer.shared.start};
  shared_from_ = {stream, transfer.shared.coarse_corner};
  shared_weight_ = {stream, transfer.shared.weight};
}

void DeviceTransfer::put_into(Topology& topology) const {
  topology.prolongation = prolongation_.data();
  topology.restriction_start = restriction_start_.data();
  topology.restriction = restriction_.data();
  topology.restriction_rest = {rest_start_.data(), rest_corner_.data(), rest_weight_.data()};
  topology.shared = {static_cast<int32_t>(shared_.size()),
                     shared_.data(),
                     {shared_start_.data(), shared_from_.data(), shared_weight_.data()}};
}

uint64_t DeviceTransfer::byte_count() const {
  return prolongation_.byte_count() + restriction_start_.byte_count() + restriction_.byte_count() +
         shared_.byte_count() + shared_start_.byte_count() + shared_from_.byte_count() +
         shared_weight_.byte_count() + rest_start_.byte_count() + rest_corner_.byte_count() +
         rest_weight_.byte_count();
}

}  // namespace burnish::cuda
