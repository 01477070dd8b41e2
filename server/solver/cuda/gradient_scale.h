#pragma once

#include <span>

#include "server/solver/cuda/device_memory.h"
#include "server/solver/cuda/views.h"

namespace burnish::cuda {

/// β per cell on its way to the device. The slider moves all cells alike: what they have in common
/// goes with the kernel, and only the others are read from memory of the host.
class GradientScale {
 public:
  /// Zero everywhere.
  GradientScale(Stream& stream, size_t cells);

  /// Needs: no kernel that reads it is under way.
  void set(std::span<const float> beta);
  const NewGradientScale& view() const { return view_; }
  uint64_t byte_count() const { return now_.byte_count() + change_.byte_count(); }

 private:
  PinnedArray<float> many_;
  DeviceArray<float> now_, change_;
  NewGradientScale view_;
};

}  // namespace burnish::cuda
