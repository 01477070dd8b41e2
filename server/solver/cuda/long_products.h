#pragma once

#include "server/solver/cuda/products.h"

// What long rows (long_rows.h) have beyond their packed entries, as a part of products. A group has
// few such entries, and some rows have most of them: all threads of its block share them out.

namespace burnish::cuda {

/// Whether products have such a part.
inline bool has_long(const Rows& rows) {
  return rows.long_rows.entry_count > 0;
}

/// Where no row is long: nothing.
template <bool kLong>
class LongPart {
 public:
  __device__ LongPart(const LongRows&, const float*, const TilePart&) {}
  __device__ void multiply(const float4*) {}
  __device__ float4 added_to(float4 product) const { return product; }
};

template <>
class LongPart<true> {
 public:
  /// Fetches entries of the group's rows; may come before await_previous().
  __device__ LongPart(const LongRows& rows, const float* entries, const TilePart& part)
      : rows_(rows),
        entries_(entries),
        part_(part),
        begin_(rows.start[part.group.first]),
        end_(rows.start[part.group.first + part.group.count]) {
    fetch_chunk(begin_);
  }

  /// Every thread of the block calls it.
  __device__ void multiply(const float4* x) {
    if (begin_ == end_) return;
    const int32_t own_begin = part_.corner >= 0 ? rows_.start[part_.corner] : end_;
    const int32_t own_end = part_.corner >= 0 ? rows_.start[part_.corner + 1] : end_;
    for (int32_t first = begin_; first < end_; first += kRoom) {
      if (first > begin_) {
        __syncthreads();
        fetch_chunk(first);
      }
      const int32_t count = min(kRoom, end_ - first);
      for (auto k = static_cast<int32_t>(threadIdx.x); k < count; k += kThreads)
        room()[k] = room()[k].x * x[__float_as_int(room()[k].w)];
      __syncthreads();
      const int32_t own_stop = min(own_end - first, count);
      for (int32_t k = max(own_begin - first, 0); k < own_stop; ++k) sum_ = sum_ + room()[k];
    }
  }
  __device__ float4 added_to(float4 product) const { return product + sum_; }

 private:
  static constexpr int32_t kRoom = 4 * kThreads;

  __device__ static float4* room() {
    __shared__ float4 room[kRoom];
    return room;
  }

  // Each thread brings what it multiplies.
  __device__ void fetch_chunk(int32_t first) const {
    const int32_t count = min(kRoom, end_ - first);
    for (auto k = static_cast<int32_t>(threadIdx.x); k < count; k += kThreads)
      room()[k] = {entries_[first + k], 0, 0, __int_as_float(rows_.column[first + k])};
  }

  const LongRows& rows_;
  const float* entries_;
  const TilePart& part_;
  int32_t begin_, end_;  // of the group's entries
  float4 sum_ = {0, 0, 0, 0};
};

}  // namespace burnish::cuda
