#include "common/denoise/ring_sums.h"

#include <algorithm>
#include <cmath>

#include "common/base/dispatch.h"
#include "common/denoise/exp8.h"
#include "common/denoise/filter_constants.h"
#include "common/denoise/triangle_rings.h"

namespace burnish {
namespace {

constexpr size_t kPairsAtOnce = 1024;  // their weights stay in the fastest cache
static_assert(kRingTrianglesMax <= kPairsAtOnce);

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

/// Writes the weights of the pairs of triangles `from` to `to`.
[[gnu::always_inline]] static inline void weigh_pairs(const RingField& field, const float* nearness,
                                                      const Float4* guides, float steepness,
                                                      size_t from, size_t to, float* weights) {
  const uint64_t first = field.starts[from], pairs = field.starts[to] - first;
  float* weight = weights;
  for (size_t t = from; t < to; ++t)
    for (uint64_t p = field.starts[t]; p < field.starts[t + 1]; ++p) {
      const float agreement = dot(guides[t], guides[field.triangles[p]]);
      *weight++ = std::min(0.f, (agreement - 1) * steepness);  // |a - b|² = 2 - 2 a·b
    }
  exp_in_place(weights, pairs);
  for (size_t i = 0; i < pairs; ++i) weights[i] *= nearness[first + i];
}

BURNISH_DISPATCH void sum_rings(const RingField& field, const float* nearness, const Float4* guides,
                                float steepness, size_t begin, size_t end, NormalAndArea* out) {
  float weights[kPairsAtOnce];
  for (size_t from = begin; from < end;) {
    const size_t to = end_of_batch(field.starts, from, end);
    weigh_pairs(field, nearness, guides, steepness, from, to, weights);
    const float* weight = weights;
    for (size_t t = from; t < to; ++t) {
      const Float4 own = field.normals[t];
      Float4 sum = own * own[3];
      for (uint64_t p = field.starts[t]; p < field.starts[t + 1]; ++p)
        sum += field.normals[field.triangles[p]] * *weight++;
      out[t] = unit_or(sum, own, own[3]);
    }
    from = to;
  }
}

/// Returns the mean normal of a ring by area.
[[gnu::always_inline]] static inline Float4 mean_normal(const RingField& field, size_t t) {
  const Float4 own = field.normals[t];
  Float4 sum = own * own[3];
  for (uint64_t p = field.starts[t]; p < field.starts[t + 1]; ++p) {
    const Float4 other = field.normals[field.triangles[p]];
    sum += other * other[3];
  }
  return unit_or(sum, own, 0);
}

BURNISH_DISPATCH void measure_rings(const RingField& field, size_t begin, size_t end, Float4* out) {
  for (size_t t = begin; t < end; ++t) {
    Float4 mean = mean_normal(field, t);
    const Float4 own = field.normals[t];
    float least = own[3] > 0 ? dot(mean, own) : 1;  // a triangle without area has no normal
    for (uint64_t p = field.starts[t]; p < field.starts[t + 1]; ++p) {
      const Float4 other = field.normals[field.triangles[p]];
      least = std::min(least, other[3] > 0 ? dot(mean, other) : 1.f);
    }
    mean[3] = std::sqrt(std::max(0.f, 2 - 2 * least));
    out[t] = mean;
  }
}

/// Writes the weights of the rings around triangle t, and at last that of its own. Returns their
/// end.
[[gnu::always_inline]] static inline float* weigh_rings(const RingField& field,
                                                        const Float4* measured, float sharpness,
                                                        size_t t, float* weight) {
  float least = measured[t][3];
  for (uint64_t p = field.starts[t]; p < field.starts[t + 1]; ++p)
    least = std::min(least, measured[field.triangles[p]][3]);
  for (uint64_t p = field.starts[t]; p < field.starts[t + 1]; ++p)
    *weight++ = (least - measured[field.triangles[p]][3]) * sharpness;
  *weight++ = (least - measured[t][3]) * sharpness;
  return weight;
}

BURNISH_DISPATCH void pick_rings(const RingField& field, const Float4* measured, float sharpness,
                                 size_t begin, size_t end, Float4* out) {
  float weights[2 * kPairsAtOnce];  // of pairs, and of the triangles themselves
  for (size_t from = begin; from < end;) {
    const size_t to = std::min(end_of_batch(field.starts, from, end), from + kPairsAtOnce);
    float* last = weights;
    for (size_t t = from; t < to; ++t) last = weigh_rings(field, measured, sharpness, t, last);
    exp_in_place(weights, static_cast<size_t>(last - weights));
    const float* weight = weights;
    for (size_t t = from; t < to; ++t) {
      Float4 sum = {};
      for (uint64_t p = field.starts[t]; p < field.starts[t + 1]; ++p)
        sum += measured[field.triangles[p]] * *weight++;
      sum += measured[t] * *weight++;
      out[t] = unit_or(sum, measured[t], 0);
    }
    from = to;
  }
}

}  // namespace burnish
