#pragma once

#include <cstdint>

#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// HaloLists::Place.
struct HaloPlace {
  int32_t shard, index;
};

/// Places of the shards' numbers.
template <typename T>
struct Stages {
  const T* of[OfShards::kMax];
};

// Puts a shard's numbers where others read them. T: float, float4 or double.

/// Does stage[i] = from[which[i]].
template <typename T>
void pack(Stream& stream, int64_t count, const int32_t* which, const T* from, T* stage);
/// Does stage[i] = from[i].
template <typename T>
void copy(Stream& stream, int64_t count, const T* from, T* stage);

// Reads numbers of others, after all earlier work of the stream.

/// Does to[i] = the number of ghosts[i].
template <typename T>
void take_ghosts(Stream& stream, int64_t count, const HaloPlace* ghosts, const Stages<T>& stages,
                 T* to);
/// Adds the copies of each sent corner in their order.
void add_copies(Stream& stream, int64_t count, const int32_t* sent, const int32_t* start,
                const HaloPlace* copies, const Stages<float4>& stages, float4* own);
/// Does to[where[i]] = stage[i].
void scatter(Stream& stream, int64_t count, const int32_t* where, const double* stage, double* to);

/// Does totals[0] = *number, before an exchange of totals.
void widen(Stream& stream, const float* number, double* totals);
/// Does *number = the largest of all totals[0], after it.
void take_largest(Stream& stream, const OfShards& of_shards, float* number);

}  // namespace burnish::cuda
