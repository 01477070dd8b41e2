#include "server/solver/cuda/device_transfer.h"

#include <cmath>
#include <cstddef>

#include "server/solver/cuda/packed.h"

namespace burnish::cuda {

static_assert(offsetof(FromCell, place) == offsetof(DepthTransfer::FromCell, place));

// By how many halvings a weight is 1, 1/2, 1/4 or 1/8, else -1.
static int halvings_of(float weight) {
  int exponent = 0;
  const bool is_power = std::frexp(weight, &exponent) == 0.5f;
  return is_power && exponent <= 1 && exponent >= -2 ? 1 - exponent : -1;
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
