#include "common/denoise/filter_constants.h"
#include "server/solver/cuda/denoise/ring_passes.h"
#include "server/solver/cuda/device/kernel.h"

// Compiled without contraction, as the processors' loops are.

namespace burnish::cuda {

namespace {

// Products and sums of all four numbers; kernel.h's drop the fourth.
__device__ float dot(float4 a, float4 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

__device__ void add(float4& sum, float4 of, float weight) {
  sum.x += of.x * weight;
  sum.y += of.y * weight;
  sum.z += of.z * weight;
}

__device__ float4 unit_or(float4 sum, float4 other, float beside) {
  const float squared = dot(sum, sum);
  if (!(squared > kNoDirection)) return {other.x, other.y, other.z, beside};
  const float length = sqrtf(squared);
  return {sum.x / length, sum.y / length, sum.z / length, beside};
}

/// Returns exp8() of x.
__device__ float exp_of(float x) {
  constexpr float kRounding = 0x1.8p23f;
  constexpr float kLog2OfE = 1.44269504f, kLn2 = 0.693359375f, kLn2Rest = -2.12194440e-4f;
  x = x < kExponentMin ? kExponentMin : x;
  const float shifted = x * kLog2OfE + kRounding;
  const float whole = shifted - kRounding;
  const float r = x - whole * kLn2 - whole * kLn2Rest;
  float sum = r * (1.f / 720) + 1.f / 120;
  sum = sum * r + 1.f / 24;
  sum = sum * r + 1.f / 6;
  sum = sum * r + 0.5f;
  sum = sum * r + 1.f;
  sum = sum * r + 1.f;
  const uint32_t power = (__float_as_uint(shifted) << 23) + 0x3f800000u;
  return sum * __uint_as_float(power);
}

__global__ void sum_kernel(Rings rings, const float4* normals, const float4* guides,
                           float steepness, float4* out) {
  await_previous();
  const int64_t t = thread_index();
  if (t >= rings.count) return;
  const float4 own = normals[t], guide = guides[t];
  float4 sum = {own.x * own.w, own.y * own.w, own.z * own.w, 0};
  const uint64_t end = rings.start[t + 1];
  for (uint64_t p = rings.start[t]; p < end; ++p) {
    const uint32_t other = rings.triangle[p];
    const float x = (dot(guide, guides[other]) - 1) * steepness;
    add(sum, normals[other], exp_of(x < 0 ? x : 0) * rings.nearness[p]);
  }
  out[t] = unit_or(sum, own, own.w);
}

__device__ float4 mean_normal(const Rings& rings, const float4* normals, int64_t t) {
  const float4 own = normals[t];
  float4 sum = {own.x * own.w, own.y * own.w, own.z * own.w, 0};
  const uint64_t end = rings.start[t + 1];
  for (uint64_t p = rings.start[t]; p < end; ++p) {
    const float4 other = normals[rings.triangle[p]];
    add(sum, other, other.w);
  }
  return unit_or(sum, own, 0);
}

/// A triangle without area agrees with any mean.
__device__ float agreement(float4 mean, float4 normal) {
  return normal.w > 0 ? dot(mean, normal) : 1.f;
}

__global__ void measure_kernel(Rings rings, const float4* normals, float4* measured) {
  await_previous();
  const int64_t t = thread_index();
  if (t >= rings.count) return;
  float4 mean = mean_normal(rings, normals, t);
  float least = agreement(mean, normals[t]);
  const uint64_t end = rings.start[t + 1];
  for (uint64_t p = rings.start[t]; p < end; ++p) {
    const float here = agreement(mean, normals[rings.triangle[p]]);
    least = here < least ? here : least;
  }
  const float squared = 2 - 2 * least;
  mean.w = sqrtf(squared > 0 ? squared : 0);
  measured[t] = mean;
}

__global__ void pick_kernel(Rings rings, const float4* measured, float sharpness, float4* guides) {
  await_previous();
  const int64_t t = thread_index();
  if (t >= rings.count) return;
  const float4 own = measured[t];
  const uint64_t begin = rings.start[t], end = rings.start[t + 1];
  float least = own.w;
  for (uint64_t p = begin; p < end; ++p) {
    const float here = measured[rings.triangle[p]].w;
    least = here < least ? here : least;
  }
  float4 sum = zero4();
  for (uint64_t p = begin; p < end; ++p) {
    const float4 other = measured[rings.triangle[p]];
    add(sum, other, exp_of((least - other.w) * sharpness));
  }
  add(sum, own, exp_of((least - own.w) * sharpness));
  guides[t] = unit_or(sum, own, 0);
}

__global__ void normals_kernel(int64_t count, const float4* normals, Float3* out) {
  await_previous();
  const int64_t t = thread_index();
  if (t < count) out[t] = {normals[t].x, normals[t].y, normals[t].z};
}

}  // namespace

void sum_rings(Stream& stream, const Rings& rings, const float4* normals, const float4* guides,
               float steepness, float4* out) {
  launch(stream, sum_kernel, rings.count, rings, normals, guides, steepness, out);
}

void measure_rings(Stream& stream, const Rings& rings, const float4* normals, float4* measured) {
  launch(stream, measure_kernel, rings.count, rings, normals, measured);
}

void pick_rings(Stream& stream, const Rings& rings, const float4* measured, float sharpness,
                float4* guides) {
  launch(stream, pick_kernel, rings.count, rings, measured, sharpness, guides);
}

void take_normals(Stream& stream, int64_t count, const float4* normals, Float3* out) {
  launch(stream, normals_kernel, count, count, normals, out);
}

}  // namespace burnish::cuda
