#include "server/solver/cuda/assembly/touched_lists.h"

#include <algorithm>

namespace burnish::cuda {

static constexpr size_t kWholeFromOneIn = 2;  // blocks of rows

TouchedLists::TouchedLists(Stream& stream, const BlockReach& reach) : reach_(&reach) {
  const size_t most = kListsOfDepth * reach.depth_count() + 1 + reach.blocks_max();
  host_ = {stream, most};
  device_ = {stream, most};
}

bool TouchedLists::find(std::span<const int32_t> cells) {
  reach_->find(cells, found_);
  return found_.back().rows.size() * kWholeFromOneIn <= reach_->finest_row_blocks();
}

void TouchedLists::bring(Stream& stream) {
  if (!stream.is_ok()) return;
  int32_t* start = host_.data();
  int32_t* next = host_.data() + kListsOfDepth * found_.size() + 1;
  for (const TouchedBlocks& depth : found_)
    for (const auto* list : {&depth.parts, &depth.rows, &depth.inverse_rows, &depth.inverses}) {
      *start++ = static_cast<int32_t>(next - host_.data());
      next = std::ranges::copy(*list, next).out;
    }
  *start = static_cast<int32_t>(next - host_.data());
  upload(stream, device_.data(),
         std::span<const int32_t>(host_.data(), static_cast<size_t>(next - host_.data())));
}

Touched TouchedLists::at(size_t depth) const {
  const auto first = static_cast<int32_t>(kListsOfDepth * depth);
  const int32_t* lists = device_.data();
  return {{lists, first}, {lists, first + 1}, {lists, first + 2}, {lists, first + 3}};
}

}  // namespace burnish::cuda
