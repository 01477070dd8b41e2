#pragma once

#include <span>

#include "common/base/types.h"
#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// Brings the displacement of corners or vertices to the host, in float32, for frames and exports.
/// A result stays valid until the next call of the same function. It is empty if the stream failed.
class Readout {
 public:
  explicit Readout(Stream& stream) : stream_(stream) {}

  std::span<const Vec3f> displacement(const Depth& finest, const Double3* u);

  /// Returns E u. Source: section 5.1.
  std::span<const Vec3f> vertex_displacement(const Depth& finest, const Double3* u,
                                             const DeviceArray<VertexPlace>& places);

  uint64_t byte_count() const;  ///< on the device

 private:
  /// Values in order, three floats each, on both sides.
  struct Values {
    DeviceArray<float> device;
    PinnedArray<Vec3f> host;
    void reserve(Stream& stream, size_t count);
    std::span<const Vec3f> read(Stream& stream);
  };

  Stream& stream_;
  Values corners_, vertices_;
};

}  // namespace burnish::cuda
