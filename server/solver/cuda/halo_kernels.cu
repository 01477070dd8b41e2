#include <algorithm>

#include "server/solver/cuda/device/kernel.h"
#include "server/solver/cuda/halo_kernels.h"

namespace burnish::cuda {

namespace {

template <typename T>
__global__ void pack_kernel(int64_t count, const int32_t* which, const T* from, T* stage) {
  await_previous();
  const int64_t i = thread_index();
  if (i < count) stage[i] = from[which[i]];
}

template <typename T>
__global__ void copy_kernel(int64_t count, const T* from, T* to) {
  await_previous();
  const int64_t i = thread_index();
  if (i < count) to[i] = from[i];
}

template <typename T>
__global__ void ghosts_kernel(int64_t count, const HaloPlace* ghosts, Stages<T> stages, T* to) {
  const int64_t i = thread_index();
  if (i < count) to[i] = stages.of[ghosts[i].shard][ghosts[i].index];
}

__global__ void add_kernel(int64_t count, const int32_t* sent, const int32_t* start,
                           const HaloPlace* copies, Stages<float4> stages, float4* own) {
  const int64_t i = thread_index();
  if (i >= count) return;
  float4 sum = own[sent[i]];
  for (int32_t k = start[i]; k < start[i + 1]; ++k)
    sum = sum + stages.of[copies[k].shard][copies[k].index];
  own[sent[i]] = sum;
}

__global__ void scatter_kernel(int64_t count, const int32_t* where, const double* stage,
                               double* to) {
  const int64_t i = thread_index();
  if (i < count) to[where[i]] = stage[i];
}

__global__ void widen_kernel(const float* number, double* totals) {
  await_previous();
  if (thread_index() == 0) totals[0] = *number;
}

__global__ void largest_kernel(OfShards of_shards, float* number) {
  if (thread_index() > 0) return;
  float most = *number;
  for (int shard = 0; shard < of_shards.count; ++shard)
    most = fmaxf(most, static_cast<float>(of_shards.totals[shard][0]));
  *number = most;
}

// A kernel that waits for other devices starts even with nothing to do: the next one may start
// early, and then waits for the last one of its stream alone.
int64_t at_least_one(int64_t count) {
  return std::max<int64_t>(count, 1);
}

}  // namespace

template <typename T>
void pack(Stream& stream, int64_t count, const int32_t* which, const T* from, T* stage) {
  launch(stream, pack_kernel<T>, count, count, which, from, stage);
}

template <typename T>
void copy(Stream& stream, int64_t count, const T* from, T* stage) {
  launch(stream, copy_kernel<T>, count, count, from, stage);
}

template <typename T>
void take_ghosts(Stream& stream, int64_t count, const HaloPlace* ghosts, const Stages<T>& stages,
                 T* to) {
  launch_whole(stream, ghosts_kernel<T>, at_least_one(count), count, ghosts, stages, to);
}

void add_copies(Stream& stream, int64_t count, const int32_t* sent, const int32_t* start,
                const HaloPlace* copies, const Stages<float4>& stages, float4* own) {
  launch_whole(stream, add_kernel, at_least_one(count), count, sent, start, copies, stages, own);
}

void scatter(Stream& stream, int64_t count, const int32_t* where, const double* stage, double* to) {
  launch_whole(stream, scatter_kernel, at_least_one(count), count, where, stage, to);
}

void widen(Stream& stream, const float* number, double* totals) {
  launch(stream, widen_kernel, 1, number, totals);
}

void take_largest(Stream& stream, const OfShards& of_shards, float* number) {
  launch_whole(stream, largest_kernel, 1, of_shards, number);
}

template void pack(Stream&, int64_t, const int32_t*, const float*, float*);
template void pack(Stream&, int64_t, const int32_t*, const double*, double*);
template void pack(Stream&, int64_t, const int32_t*, const float4*, float4*);
template void copy(Stream&, int64_t, const float4*, float4*);
template void copy(Stream&, int64_t, const double*, double*);
template void take_ghosts(Stream&, int64_t, const HaloPlace*, const Stages<float>&, float*);
template void take_ghosts(Stream&, int64_t, const HaloPlace*, const Stages<float4>&, float4*);

}  // namespace burnish::cuda
