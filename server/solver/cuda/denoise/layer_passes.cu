#include "common/denoise/filter_constants.h"
#include "server/solver/cuda/denoise/layer_passes.h"
#include "server/solver/cuda/device/kernel.h"

// Compiled without contraction, as the processors' loops are.

namespace burnish::cuda {

namespace {

__device__ float along(float4 normal, float4 way) {
  return normal.x * way.x + normal.y * way.y + normal.z * way.z;
}

__device__ double dot(Double3 a, Double3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

__device__ Double3 cross(Double3 a, Double3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Returns the way from a place to a triangle's centre along the normal.
__device__ float height_at(const Places& places, int64_t v, uint32_t t, float4 normal) {
  const Corners corners = places.triangles[t];
  const Double3 place = places.at[v];
  const Double3 sum = (places.at[corners.at[0]] - place) + (places.at[corners.at[1]] - place) +
                      (places.at[corners.at[2]] - place);
  const double thrice = 3 * places.unit;
  const Double3 to_centre = {sum.x / thrice, sum.y / thrice, sum.z / thrice};
  return static_cast<float>(dot(to_double(normal), to_centre));
}

__global__ void begin_kernel(Places places, const float4* normals, float* offsets, float4* moves) {
  await_previous();
  const int64_t v = thread_index();
  if (v >= places.count) return;
  float area = 0;
  const uint64_t end = places.fan_start[v + 1];
  for (uint64_t i = places.fan_start[v]; i < end; ++i) {
    const uint32_t t = places.fans[i];
    const float4 normal = normals[t];
    offsets[i] = height_at(places, v, t, normal) * sqrtf(normal.w);
    area += normal.w;
  }
  moves[v] = {0, 0, 0, area > kPlaceAreaMin ? 1 / area : 0};
}

__global__ void planes_kernel(int64_t count, const float4* normals, float4* planes) {
  await_previous();
  const int64_t t = thread_index();
  if (t >= count) return;
  const float4 normal = normals[t];
  const float root = sqrtf(normal.w);
  planes[t] = {normal.x * root, normal.y * root, normal.z * root, 0};
}

__global__ void measure_kernel(Places places, const float4* moves, float4* planes) {
  await_previous();
  const int64_t t = thread_index();
  if (t >= places.triangle_count) return;
  const Corners corners = places.triangles[t];
  const float4 sum = moves[corners.at[0]] + moves[corners.at[1]] + moves[corners.at[2]];
  planes[t].w = along(planes[t], sum) * (1.f / 3);
}

__global__ void pull_kernel(Places places, LayerArrays arrays) {
  await_previous();
  const int64_t v = thread_index();
  if (v >= places.count) return;
  const float4 move = arrays.moves[v];
  float4 sum = zero4();
  const uint64_t end = places.fan_start[v + 1];
  for (uint64_t i = places.fan_start[v]; i < end; ++i) {
    const float4 plane = arrays.planes[places.fans[i]];
    sum = sum + (arrays.offsets[i] + (plane.w - along(plane, move))) * plane;
  }
  const float4 moved = move + move.w * sum;
  arrays.moves[v] = {moved.x, moved.y, moved.z, move.w};
}

__global__ void layer_kernel(Places places, const float4* moves, Float3* layer) {
  await_previous();
  const int64_t v = thread_index();
  if (v >= places.count) return;
  const float4 move = to_float(places.unit * to_double(moves[v]));
  layer[v] = {move.x, move.y, move.z};
}

__device__ Double3 to_double(Float3 a) {
  return {a.x, a.y, a.z};
}

__device__ bool has_turned(const Places& places, const Float3* layer, int64_t t) {
  if (!places.is_surface[t]) return false;
  const auto& [a, b, c] = places.triangles[t].at;
  const Double3 ab = places.at[b] - places.at[a], ac = places.at[c] - places.at[a];
  const Double3 move = to_double(layer[a]);
  return dot(cross(ab, ac),
             cross(ab + to_double(layer[b]) - move, ac + to_double(layer[c]) - move)) < 0;
}

__global__ void turned_kernel(Places places, const Float3* layer, uint8_t* turned) {
  await_previous();
  const int64_t t = thread_index();
  if (t < places.triangle_count) turned[t] = has_turned(places, layer, t);
}

__global__ void stay_kernel(Places places, const uint8_t* turned, Float3* layer) {
  await_previous();
  const int64_t v = thread_index();
  if (v >= places.count) return;
  const uint64_t end = places.fan_start[v + 1];
  for (uint64_t i = places.fan_start[v]; i < end; ++i)
    if (turned[places.fans[i]]) layer[v] = {0, 0, 0};
}

__global__ void share_kernel(Places places, Float3* layer) {
  await_previous();
  const int64_t v = thread_index();
  if (v < places.count && places.place[v] != v) layer[v] = layer[places.place[v]];
}

}  // namespace

void begin_layer(Stream& stream, const Places& places, const float4* normals,
                 const LayerArrays& arrays) {
  launch(stream, begin_kernel, places.count, places, normals, arrays.offsets, arrays.moves);
  launch(stream, planes_kernel, places.triangle_count, places.triangle_count, normals,
         arrays.planes);
}

void update_layer(Stream& stream, const Places& places, const LayerArrays& arrays) {
  launch(stream, measure_kernel, places.triangle_count, places, arrays.moves, arrays.planes);
  launch(stream, pull_kernel, places.count, places, arrays);
}

void end_layer(Stream& stream, const Places& places, const LayerArrays& arrays) {
  launch(stream, layer_kernel, places.count, places, arrays.moves, arrays.layer);
  for (int round = 0; round < kGuardRounds; ++round) {
    launch(stream, turned_kernel, places.triangle_count, places, arrays.layer, arrays.turned);
    launch(stream, stay_kernel, places.count, places, arrays.turned, arrays.layer);
  }
  launch(stream, share_kernel, places.count, places, arrays.layer);
}

}  // namespace burnish::cuda
