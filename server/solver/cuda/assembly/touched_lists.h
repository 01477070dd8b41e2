#pragma once

#include <span>
#include <vector>

#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/views.h"
#include "server/solver/hierarchy/touched_blocks.h"

namespace burnish::cuda {

/// The blocks that a session's local new metric touches, on their way to the device. Their places
/// there never change, so graphs can read them.
class TouchedLists {
 public:
  TouchedLists() = default;
  /// `reach` must outlive this.
  TouchedLists(Stream& stream, const BlockReach& reach);

  /// Finds the blocks. Returns whether they are few, so that a local new metric is worth while.
  /// Shapes: cells of the finest depth.
  bool find(std::span<const int32_t> cells);
  /// Copies what find() has found. Needs: no running kernel or copy reads the lists.
  void bring(Stream& stream);
  /// Shapes: depths from the coarsest on.
  Touched at(size_t depth) const;
  uint64_t byte_count() const { return device_.byte_count(); }

 private:
  static constexpr int32_t kListsOfDepth = 4;

  const BlockReach* reach_ = nullptr;
  std::vector<TouchedBlocks> found_;
  // The start of each list, and the end of the last; then the lists.
  PinnedArray<int32_t> host_;
  DeviceArray<int32_t> device_;
};

}  // namespace burnish::cuda
