#include "server/solver/cuda/device/kernel.h"
#include "server/solver/cuda/readout.h"

namespace burnish::cuda {

namespace {

__device__ void store(float* values, int64_t i, float4 value) {
  values[3 * i] = value.x;
  values[3 * i + 1] = value.y;
  values[3 * i + 2] = value.z;
}

__global__ void corners_kernel(int64_t count, const Double3* u, float* values) {
  await_previous();
  const int64_t i = thread_index();
  if (i < count) store(values, i, to_float(u[i]));
}

__global__ void round_kernel(int64_t count, const Double3* u, float4* rounded) {
  await_previous();
  const int64_t i = thread_index();
  if (i < count) rounded[i] = to_float(u[i]);
}

__global__ void vertices_kernel(int64_t count, const VertexPlace* places, const Eight* cell_corners,
                                const float4* u, float* values) {
  await_previous();
  const int64_t i = thread_index();
  if (i >= count) return;
  const VertexPlace place = places[i];
  float4 sum = zero4();
  if (place.cell >= 0) {
    const Eight corners = cell_corners[place.cell];
#pragma unroll
    for (int a = 0; a < 8; ++a) {
      float weight = 1;
#pragma unroll
      for (int axis = 0; axis < 3; ++axis)
        weight *= a >> axis & 1 ? place.local[axis] : 1 - place.local[axis];
      sum = sum + weight * u[corners.at[a]];
    }
  }
  store(values, i, sum);
}

}  // namespace

void Readout::Values::reserve(Stream& stream, size_t count) {
  if (host.size() == count) return;
  device = {stream, 3 * count};
  host = {stream, count};
}

std::span<const Vec3f> Readout::Values::read(Stream& stream) {
  static_assert(sizeof(Vec3f) == 3 * sizeof(float));
  device.download(stream, {reinterpret_cast<float*>(host.data()), 3 * host.size()});
  return {host.data(), stream.is_ok() ? host.size() : 0};
}

std::span<const Vec3f> Readout::displacement(const Depth& finest, const Double3* u) {
  const int64_t n = finest.topology.corner_count;
  corners_.reserve(stream_, n);
  launch(stream_, corners_kernel, n, n, u, corners_.device.data());
  return corners_.read(stream_);
}

// Between two steps the V-cycle's residual is not needed: u in float32 takes its place.
std::span<const Vec3f> Readout::vertex_displacement(const Depth& finest, const Double3* u,
                                                    const DeviceArray<VertexPlace>& places) {
  const int64_t n = finest.topology.corner_count;
  const auto count = static_cast<int64_t>(places.size());
  vertices_.reserve(stream_, places.size());
  launch(stream_, round_kernel, n, n, u, finest.r);
  launch(stream_, vertices_kernel, count, count, places.data(), finest.topology.cell_corners,
         finest.r, vertices_.device.data());
  return vertices_.read(stream_);
}

uint64_t Readout::byte_count() const {
  return corners_.device.byte_count() + vertices_.device.byte_count();
}

}  // namespace burnish::cuda
