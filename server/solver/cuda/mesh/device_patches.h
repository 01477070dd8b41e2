#pragma once

#include <vector>

#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/views.h"
#include "server/solver/hierarchy/patches.h"

namespace burnish::cuda {

/// Patches on the device.
class DevicePatches {
 public:
  DevicePatches() = default;
  DevicePatches(Stream& stream, const Patches& patches)
      : start_(stream, patches.start),
        corner_(stream, patches.corner),
        entry_start_(stream, patches.entry_start) {}

  PatchList view() const { return {start_.data(), corner_.data(), entry_start_.data()}; }
  uint64_t byte_count() const {
    return start_.byte_count() + corner_.byte_count() + entry_start_.byte_count();
  }

 private:
  DeviceArray<int32_t> start_, corner_;
  DeviceArray<int64_t> entry_start_;
};

}  // namespace burnish::cuda
