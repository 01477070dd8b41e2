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
  __device__ void start(const float4*) {}
  __device__ void finish(const float4*) {}
  __device__ float4 added_to(float4 product) const { return product; }
};

/// An entry for each thread at first, four for each from then on.
template <>
class LongPart<true> {
 public:
  /// Fetches entries; may come before await_previous().
  __device__ LongPart(const LongRows& rows, const float* entries, const TilePart& part)
      : rows_(rows),
        entries_(entries),
        begin_(rows.start[part.group.first]),
        end_(rows.start[part.group.first + part.group.count]),
        own_begin_(part.corner >= 0 ? rows.start[part.corner] : end_),
        own_end_(part.corner >= 0 ? rows.start[part.corner + 1] : end_) {
    const int32_t k = begin_ + static_cast<int32_t>(threadIdx.x);
    column_ = k < end_ ? rows.column[k] : 0;
    entry_ = k < end_ ? entries[k] : 0;
  }

  /// Before the tile is filled, so that all loads are under way together.
  __device__ void start(const float4* x) {
    if (begin_ < end_) there_ = x[column_];
  }
  /// Afterwards. Every thread of the block calls it.
  __device__ void finish(const float4* x) {
    if (begin_ == end_) return;
    room()[threadIdx.x] = entry_ * there_;
    __syncthreads();
    add_own(begin_, kThreads);
    for (int32_t first = begin_ + kThreads; first < end_; first += kRoom) {
      __syncthreads();
      multiply_chunk(x, first);
      __syncthreads();
      add_own(first, kRoom);
    }
  }
  __device__ float4 added_to(float4 product) const { return product + sum_; }

 private:
  static constexpr int32_t kEach = 4;
  static constexpr int32_t kRoom = kEach * kThreads;

  __device__ static float4* room() {
    __shared__ float4 room[kRoom];
    return room;
  }

  __device__ void multiply_chunk(const float4* x, int32_t first) const {
#pragma unroll
    for (int j = 0; j < kEach; ++j) {
      const int32_t at = static_cast<int32_t>(threadIdx.x) + j * kThreads;
      if (first + at < end_) room()[at] = entries_[first + at] * x[rows_.column[first + at]];
    }
  }

  __device__ void add_own(int32_t first, int32_t count) {
    const int32_t stop = min(own_end_ - first, count);
    for (int32_t k = max(own_begin_ - first, 0); k < stop; ++k) sum_ = sum_ + room()[k];
  }

  const LongRows& rows_;
  const float* entries_;
  int32_t begin_, end_;          // of the group's entries
  int32_t own_begin_, own_end_;  // of the thread's row
  int32_t column_;
  float entry_;
  float4 there_ = {0, 0, 0, 0}, sum_ = {0, 0, 0, 0};
};

}  // namespace burnish::cuda
