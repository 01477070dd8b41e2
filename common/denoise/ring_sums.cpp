#include "common/denoise/ring_sums.h"

#include <algorithm>
#include <cmath>

#include "common/base/dispatch.h"
#include "common/denoise/exp8.h"
#include "common/denoise/triangle_rings.h"

namespace burnish {
namespace {

constexpr size_t kPairsAtOnce = 1024;  // their weights stay in the fastest cache
static_assert(kRingTrianglesMax <= kPairsAtOnce);

constexpr float kNoDirection = 1e-30f;  // of a squared length

}  // namespace

[[gnu::always_inline]] static inline float dot(Float4 a, Float4 b) {
  const Float4 product = a * b;
  return product[0] + product[1] + product[2];
}

/// Returns the unit vector with `beside` as the fourth; `other` where the sum has no direction.
[[gnu::always_inline]] static inline Float4 unit_or(Float4 sum, Float4 other, float beside) {
  const float squared = dot(sum, sum);
  Float4 result = squared > kNoDirection ? sum / std::sqrt(squared) : other;
  result[3] = beside;
  return result;
}

/// Returns how many triangles from `t` on have no more pairs than are worked at once.
[[gnu::always_inline]] static inline size_t end_of_batch(const uint64_t* starts, size_t t,
                                                         size_t end) {
  size_t last = t + 1;
  while (last < end && starts[last + 1] - starts[t] <= kPairsAtOnce) ++last;
  return last;
}

BURNISH_DISPATCH void sum_rings(const RingField& field, const float* nearness, const Float4* guides,
                                float steepness, size_t begin, size_t end, NormalAndArea* out) {
  float weights[kPairsAtOnce];
  const uint64_t* starts = field.starts;
  for (size_t from = begin; from < end;) {
    const size_t to = end_of_batch(starts, from, end);
    const uint64_t first = starts[from], pairs = starts[to] - first;
    // |a - b|² = 2 - 2 a·b
    float* weight = weights;
    for (size_t t = from; t < to; ++t)
      for (uint64_t p = starts[t]; p < starts[t + 1]; ++p)
        *weight++ = std::min(0.f, (dot(guides[t], guides[field.triangles[p]]) - 1) * steepness);
    exp_in_place(weights, pairs);
    for (size_t i = 0; i < pairs; ++i) weights[i] *= nearness[first + i];
    weight = weights;
    for (size_t t = from; t < to; ++t) {
      const Float4 own = field.normals[t];
      Float4 sum = own * own[3];
      for (uint64_t p = starts[t]; p < starts[t + 1]; ++p)
        sum += field.normals[field.triangles[p]] * *weight++;
      out[t] = unit_or(sum, own, own[3]);
    }
    from = to;
  }
}

BURNISH_DISPATCH void measure_rings(const RingField& field, size_t begin, size_t end, Float4* out) {
  const uint64_t* starts = field.starts;
  for (size_t t = begin; t < end; ++t) {
    const Float4 own = field.normals[t];
    Float4 sum = own * own[3];
    for (uint64_t p = starts[t]; p < starts[t + 1]; ++p) {
      const Float4 other = field.normals[field.triangles[p]];
      sum += other * other[3];
    }
    const Float4 mean = unit_or(sum, own, 0);
    float least = own[3] > 0 ? dot(mean, own) : 1;
    for (uint64_t p = starts[t]; p < starts[t + 1]; ++p) {
      const Float4 other = field.normals[field.triangles[p]];
      least = std::min(least, other[3] > 0 ? dot(mean, other) : 1.f);
    }
    Float4 measured = mean;
    measured[3] = std::sqrt(std::max(0.f, 2 - 2 * least));
    out[t] = measured;
  }
}

BURNISH_DISPATCH void pick_rings(const RingField& field, const Float4* measured, float sharpness,
                                 size_t begin, size_t end, Float4* out) {
  float weights[kPairsAtOnce];
  const uint64_t* starts = field.starts;
  for (size_t from = begin; from < end;) {
    const size_t to = end_of_batch(starts, from, end);
    float* weight = weights;
    for (size_t t = from; t < to; ++t) {
      float least = measured[t][3];
      for (uint64_t p = starts[t]; p < starts[t + 1]; ++p)
        least = std::min(least, measured[field.triangles[p]][3]);
      for (uint64_t p = starts[t]; p < starts[t + 1]; ++p)
        *weight++ = (least - measured[field.triangles[p]][3]) * sharpness;
      out[t][3] = (least - measured[t][3]) * sharpness;
    }
    exp_in_place(weights, starts[to] - starts[from]);
    weight = weights;
    for (size_t t = from; t < to; ++t) {
      Float8 own_weight = {out[t][3]};
      exp8(own_weight);
      Float4 sum = measured[t] * own_weight[0];
      for (uint64_t p = starts[t]; p < starts[t + 1]; ++p)
        sum += measured[field.triangles[p]] * *weight++;
      out[t] = unit_or(sum, measured[t], 0);
    }
    from = to;
  }
}

}  // namespace burnish
