#pragma once

#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/device/views.h"
#include "server/solver/hierarchy/depth_transfer.h"

namespace burnish::cuda {

class DeviceListedCorners {
 public:
  DeviceListedCorners() = default;
  DeviceListedCorners(Stream& stream, const std::vector<int32_t>& corner,
                      const std::vector<int32_t>& start, const std::vector<int32_t>& from,
                      const std::vector<float>& weight)
      : corner_(stream, corner),
        start_(stream, start),
        from_(stream, from),
        weight_(stream, weight) {}

  ListedCorners view() const {
    return {static_cast<int32_t>(corner_.size()), corner_.data(), start_.data(), from_.data(),
            weight_.data()};
  }
  uint64_t byte_count() const {
    return corner_.byte_count() + start_.byte_count() + from_.byte_count() + weight_.byte_count();
  }

 private:
  DeviceArray<int32_t> corner_, start_, from_;
  DeviceArray<float> weight_;
};

/// A depth's DepthTransfer on the device; empty for the coarsest.
class DeviceTransfer {
 public:
  DeviceTransfer() = default;
  DeviceTransfer(Stream& stream, const DepthTransfer& transfer);

  /// Fills in its part of a depth's topology.
  void put_into(Topology& topology) const;
  uint64_t byte_count() const;

 private:
  DeviceArray<FromCell> prolongation_;
  DeviceArray<int64_t> restriction_start_;
  DeviceArray<uint32_t> restriction_;
  DeviceListedCorners shared_, listed_;
};

}  // namespace burnish::cuda
