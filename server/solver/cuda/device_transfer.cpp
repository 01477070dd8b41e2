#include "server/solver/cuda/device_transfer.h"

#include <cstddef>

#include "server/solver/cuda/packed_restriction.h"

namespace burnish::cuda {

static_assert(offsetof(FromCell, place) == offsetof(DepthTransfer::FromCell, place));

// Shared corners, which are of no cell, by their numbers.
static std::vector<FromCell> numbered_prolongation(const DepthTransfer& transfer) {
  std::vector<FromCell> prolongation(transfer.prolongation.size());
  for (size_t i = 0; i < prolongation.size(); ++i)
    prolongation[i] = {transfer.prolongation[i].cell, transfer.prolongation[i].place};
  for (int32_t s = 0; s < transfer.shared.count(); ++s)
    prolongation[transfer.shared.corner[s]].cell = -1 - s;
  return prolongation;
}

DeviceTransfer::DeviceTransfer(Stream& stream, const DepthTransfer& transfer) {
  if (transfer.prolongation.empty()) return;
  prolongation_ = {stream, numbered_prolongation(transfer)};
  const PackedRestriction restriction = pack_restriction(transfer);
  restriction_start_ = {stream, restriction.start};
  restriction_ = {stream, restriction.packed};
  rest_start_ = {stream, restriction.rest_start};
  rest_corner_ = {stream, restriction.rest_corner};
  rest_weight_ = {stream, restriction.rest_weight};
  if (transfer.shared.count() == 0) return;
  shared_start_ = {stream, transfer.shared.start};
  shared_corner_ = {stream, transfer.shared.coarse_corner};
  shared_weight_ = {stream, transfer.shared.weight};
}

void DeviceTransfer::put_into(Topology& topology) const {
  topology.prolongation = prolongation_.data();
  topology.restriction_start = restriction_start_.data();
  topology.restriction = restriction_.data();
  topology.restriction_rest = {rest_start_.data(), rest_corner_.data(), rest_weight_.data()};
  topology.shared = {shared_start_.data(), shared_corner_.data(), shared_weight_.data()};
}

uint64_t DeviceTransfer::byte_count() const {
  return prolongation_.byte_count() + restriction_start_.byte_count() + restriction_.byte_count() +
         shared_start_.byte_count() + shared_corner_.byte_count() + shared_weight_.byte_count() +
         rest_start_.byte_count() + rest_corner_.byte_count() + rest_weight_.byte_count();
}

}  // namespace burnish::cuda
