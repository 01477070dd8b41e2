#pragma once

#include "server/solver/cuda/products/products.h"

// The part of products from long rows (long_rows.h), beyond their packed entries. A group has few
// such entries, and some rows have most of them: all threads of the block share them.

namespace burnish::cuda {

/// Returns whether products have such a part.
inline bool has_long(const Rows& rows) {
  return rows.long_rows.entry_count > 0;
}

/// Does nothing if no row is long.
template <bool kLong>
class LongPart {
 public:
  __device__ LongPart(const LongRows&, const float*, const TilePart&) {}
  __device__ void start(const float4*) {}
  __device__ void finish(const float4*) {}
  __device__ float4 added_to(float4 product) const { return product; }
};

/// Works by chunks of four entries per thread. The first chunk, except the vector's numbers, waits
/// in the block's room. Each thread's first number comes together with the tile's.
template <>
class LongPart<true> {
 public:
  /// Fetches entries; may come before await_previous().
  __device__ LongPart(const LongRows& rows, const float* entries, const TilePart& part)
      : rows_(rows),
        entries_(entries),
        begin_(rows.start[part.group.first]),
        end_(rows.start[part.group.first + part.group.count]) {
    const bool has_any = begin_ < end_ && part.corner >= 0;
    own_begin_ = has_any ? rows.start[part.corner] : end_;
    own_end_ = has_any ? rows.start[part.corner + 1] : end_;
    fetch_chunk(begin_);
  }

  /// Call before the tile is filled.
  __device__ void start(const float4* x) {
    if (begin_ + own(0) < end_) first_there_ = x[__float_as_int(room()[own(0)].w)];
  }
  /// Call after the tile is filled. Every thread of the block calls it.
  __device__ void finish(const float4* x) {
    if (begin_ == end_) return;
    room()[own(0)] = room()[own(0)].x * first_there_;
    if (begin_ + kThreads < end_) multiply_chunk<1>(x, begin_);
    add_own(begin_);
    for (int32_t first = begin_ + kRoom; first < end_; first += kRoom) {
      __syncthreads();
      fetch_chunk(first);
      multiply_chunk<0>(x, first);
      add_own(first);
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
  // Returns the place of the thread's entry j of a chunk.
  __device__ static int32_t own(int j) { return static_cast<int32_t>(threadIdx.x) + j * kThreads; }

  __device__ void fetch_chunk(int32_t first) const {
    for (int j = 0; j < kEach && first + own(j) < end_; ++j)
      room()[own(j)] = {entries_[first + own(j)], 0, 0,
                        __int_as_float(rows_.column[first + own(j)])};
  }

  // Multiplies the thread's entries from kFrom on.
  template <int kFrom>
  __device__ void multiply_chunk(const float4* x, int32_t first) const {
    float4 there[kEach];
#pragma unroll
    for (int j = kFrom; j < kEach; ++j)
      if (first + own(j) < end_) there[j] = x[__float_as_int(room()[own(j)].w)];
#pragma unroll
    for (int j = kFrom; j < kEach; ++j)
      if (first + own(j) < end_) room()[own(j)] = room()[own(j)].x * there[j];
  }

  __device__ void add_own(int32_t first) {
    __syncthreads();
    const int32_t stop = min(own_end_ - first, kRoom);
#pragma unroll 4
    for (int32_t k = max(own_begin_ - first, 0); k < stop; ++k) sum_ = sum_ + room()[k];
  }

  const LongRows& rows_;
  const float* entries_;
  int32_t begin_, end_;          // the group's entries
  int32_t own_begin_, own_end_;  // entries of the thread's row
  float4 first_there_ = {0, 0, 0, 0}, sum_ = {0, 0, 0, 0};
};

}  // namespace burnish::cuda
