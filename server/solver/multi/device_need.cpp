#include "server/solver/multi/device_need.h"

#include <algorithm>

#include "server/solver/cuda/cuda_filter.h"
#include "server/solver/multi/cut.h"

namespace burnish {

// About 1,555 bytes with the scan, on scans of 0.3 to 23 million corners. Kept edges may come
// later: their matrices take 72 bytes for each cell, and a cell has about two corners.
static constexpr uint64_t kBytesPerCorner = 1670;  // of the finest depth

// Cells at the cut, the whole depths of the first shard, and memory that CUDA takes for itself.
static constexpr uint64_t kPartForItself = 10;  // of a device, in a hundred

uint64_t predict_device_bytes(const Multigrid& on) {
  return kBytesPerCorner * on.hierarchy->depths.back().grid.corners.size() +
         on.plan->patches.entry_count() * sizeof(float) +
         predict_cuda_filter_bytes(on.prepared->triangles.size(), on.prepared->vertices.size());
}

int shards_that_fit(uint64_t bytes, uint64_t device_bytes) {
  const uint64_t room = device_bytes / 100 * (100 - kPartForItself);
  if (bytes <= device_bytes || room == 0) return 1;
  return static_cast<int>(std::min<uint64_t>((bytes + room - 1) / room, kShardsMax));
}

}  // namespace burnish
