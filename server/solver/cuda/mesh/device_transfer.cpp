#include "server/solver/cuda/mesh/device_transfer.h"

#include <cstddef>

#include "server/solver/cuda/mesh/packed_restriction.h"

namespace burnish::cuda {

static_assert(offsetof(FromCell, place) == offsetof(burnish::FromCell, place));

DeviceTransfer::DeviceTransfer(Stream& stream, const DepthTransfer& transfer) {
  if (transfer.prolongation.empty()) return;
  prolongation_ = DeviceArray<FromCell>::copy_of(stream, transfer.prolongation);
  const PackedRestriction restriction = pack_restriction(transfer);
  restriction_start_ = {stream, restriction.start};
  restriction_ = {stream, restriction.packed};
  listed_ = {stream, restriction.listed, restriction.listed_start, restriction.listed_from,
             restriction.listed_weight};
  const DepthTransfer::SharedCorners& shared = transfer.shared;
  shared_ = {stream, shared.corner, shared.start, shared.coarse_corner, shared.weight};
}

void DeviceTransfer::put_into(Topology& topology) const {
  topology.prolongation = prolongation_.data();
  topology.restriction_start = restriction_start_.data();
  topology.restriction = restriction_.data();
  topology.shared = shared_.view();
  topology.listed = listed_.view();
}

uint64_t DeviceTransfer::byte_count() const {
  return prolongation_.byte_count() + restriction_start_.byte_count() + restriction_.byte_count() +
         shared_.byte_count() + listed_.byte_count();
}

}  // namespace burnish::cuda
