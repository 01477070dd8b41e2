#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "server/solver/cuda/device/device_memory.h"
#include "server/solver/cuda/halo.h"
#include "server/solver/cuda/halo_kernels.h"

namespace burnish::cuda {

inline constexpr int kTurns = 2;  // places for the others, which take turns

/// Memory of one device that others read too. The pool's memory is not open to them.
template <typename T>
class SharedArray {
 public:
  SharedArray() = default;
  SharedArray(Stream& stream, size_t count) {
    stream.get();
    void* memory = nullptr;
    if (count == 0 || !stream.check(cudaMalloc(&memory, count * sizeof(T)), "taking memory"))
      return;
    data_.reset(static_cast<T*>(memory));
    stream.check(cudaMemsetAsync(memory, 0, count * sizeof(T), stream.get()), "clearing memory");
  }
  T* data() const { return data_.get(); }

 private:
  struct Free {
    void operator()(T* memory) const { cudaFree(memory); }
  };
  std::unique_ptr<T, Free> data_;
};

/// A shard's lists of one depth on its device, and the place for its numbers.
struct DepthOnDevice {
  int64_t own, sent_count, ghost_count;
  size_t room;  ///< numbers of one place
  DeviceArray<int32_t> sent, copy_start;
  DeviceArray<HaloPlace> copies, ghosts;
  SharedArray<float4> stages;
  int turn = 0;

  DepthOnDevice(Stream& stream, const HaloLists& lists, int64_t own_corners);

  template <typename T>
  T* stage() const {
    return reinterpret_cast<T*>(stages.data() + turn * room);
  }
};

/// One shard's side of all exchanges.
struct ShardOnDevice {
  Stream stream;  ///< for making it
  int border_depth;
  std::vector<DepthOnDevice> depths;
  SharedArray<double> totals;  ///< per slot and turn
  std::vector<int> turn_of_slot;
  DeviceArray<double> largest;
  int64_t border_count = 0;          ///< numbers that it makes for the first shard
  DeviceArray<int32_t> border_from;  ///< their places here
  DeviceArray<int32_t> border_to;    ///< and there, on the first shard's device
  SharedArray<double> border_stage;
  cudaEvent_t ready = nullptr;
  // The shard has arrived at the barrier with these.
  Stream* now = nullptr;
  void* vector = nullptr;

  /// `first`: the first shard's lists, with a stream of its device.
  ShardOnDevice(const ShardLists& lists, const ShardLists& first, Stream& stream_of_first);
  ShardOnDevice(const ShardOnDevice&) = delete;
  ShardOnDevice& operator=(const ShardOnDevice&) = delete;
  ~ShardOnDevice();

  DepthOnDevice& at(int depth) { return depths[depth - border_depth]; }
  double* totals_of(int slot, int turn) const {
    return totals.data() + (kTurns * slot + turn) * OfShards::kTotals;
  }
};

}  // namespace burnish::cuda
