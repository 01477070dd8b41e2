#include "server/solver/cuda/mesh/device_halo.h"

#include "server/solver/cuda/mesh/device_irregular.h"

namespace burnish::cuda {

static_assert(sizeof(HaloPlace) == sizeof(HaloLists::Place));

// Returns the places on the device of all numbers of some cells and ties.
static std::vector<int32_t> places_of(std::span<const int32_t> parts, int32_t cells) {
  std::vector<int32_t> places;
  for (const int32_t part : parts) {
    const bool is_cell = part < cells;
    const int32_t first =
        is_cell ? number_of_cell(part, 0) : number_of_tie(cells, part - cells, 0, 0);
    for (int32_t n = 0; n < (is_cell ? kNumbersPerCell : kNumbersPerTie); ++n)
      places.push_back(place_of_number(first + n, cells));
  }
  return places;
}

DepthOnDevice::DepthOnDevice(Stream& stream, const HaloLists& lists, int64_t own_corners)
    : own(own_corners),
      sent_count(std::ssize(lists.sent)),
      ghost_count(std::ssize(lists.ghosts)),
      room(std::max(lists.sent.size(), lists.ghosts.size())),
      sent(stream, lists.sent),
      copy_start(stream, lists.copies.start),
      copies(DeviceArray<HaloPlace>::copy_of(stream, lists.copies.item)),
      ghosts(DeviceArray<HaloPlace>::copy_of(stream, lists.ghosts)),
      stages(stream, kTurns * room) {}

ShardOnDevice::ShardOnDevice(const ShardLists& lists, const ShardLists& first,
                             Stream& stream_of_first)
    : stream(lists.device),
      border_depth(lists.hierarchy->finest - static_cast<int>(lists.depths.size()) + 1) {
  for (size_t i = 0; i < lists.depths.size(); ++i)
    depths.emplace_back(stream, lists.depths[i],
                        lists.hierarchy->at(border_depth + static_cast<int>(i)).own_count());
  const size_t slots = lists.hierarchy->finest + 2;  // a depth each, and the solver's
  turn_of_slot.assign(slots, 0);
  totals = {stream, slots * kTurns * OfShards::kTotals};
  largest = {stream, OfShards::kTotals};
  const auto cells = [&](const ShardLists& of) {
    return of.hierarchy->at(border_depth).grid.cell_count();
  };
  const std::vector<int32_t> from = places_of(lists.border->here, cells(lists));
  border_count = std::ssize(from);
  border_from = {stream, from};
  border_to = {stream_of_first, places_of(lists.border->whole, cells(first))};
  border_stage = {stream, from.size()};
  stream.get();
  stream.check(cudaEventCreateWithFlags(&ready, cudaEventDisableTiming), "creating an event");
  stream.synchronize();
  stream_of_first.synchronize();
}

ShardOnDevice::~ShardOnDevice() {
  if (ready != nullptr) cudaEventDestroy(ready);
}

}  // namespace burnish::cuda
