#include "client/raster/triangle_filler.h"

#include "common/base/dispatch.h"

namespace burnish {
namespace {

/// The picture as the loops below take it.
struct FillTarget {
  SampleKey* keys;
  int width;
  int first_column, last_column, last_row;
  bool is_shared;
  SamplePlaces places;
};

constexpr int kSmallSubpixels = 1 << 13;  // products of sides fit into 32 bits

/// Three edges of a triangle; at a point on its inner side a value is not negative. Values at the
/// upper left corner of a pixel, steps to the next pixel, and what each sample adds.
template <typename Number>
struct Edges {
  Number at_row[3];
  Number by_x[3], by_y[3];
  Number of_sample[3][kSamplesMax];
};

/// The plane of nearness over the picture: what a triangle's second and third corner add to that of
/// the first, for each step of the edges opposite to them.
struct NearnessPlane {
  float first, by_second, by_third;
};

}  // namespace

[[gnu::always_inline]] static inline int least(int a, int b, int c) {
  const int d = a < b ? a : b;
  return d < c ? d : c;
}

[[gnu::always_inline]] static inline int largest(int a, int b, int c) {
  const int d = a > b ? a : b;
  return d > c ? d : c;
}

// Other threads may write the same sample: the largest key stays.
[[gnu::always_inline]] static inline void show(SampleKey* sample, SampleKey key, bool is_shared) {
  if (!is_shared) {
    if (key > *sample) *sample = key;
    return;
  }
  SampleKey seen = __atomic_load_n(sample, __ATOMIC_RELAXED);
  while (key > seen && !__atomic_compare_exchange_n(sample, &seen, key, true, __ATOMIC_RELAXED,
                                                    __ATOMIC_RELAXED)) {
  }
}

// An edge takes the samples on it if it is an upper or a left one: with y down and the inner side
// to its right, it goes up, or level to the right. Others begin one step further inside.
template <typename Number>
[[gnu::always_inline]] static inline void set_edge(Edges<Number>& edges, int which,
                                                   const ScreenVertex& from, const ScreenVertex& to,
                                                   int left, int top, const SamplePlaces& places) {
  const Number dx = Number(to.x) - from.x, dy = Number(to.y) - from.y;
  const bool takes_samples = dy < 0 || (dy == 0 && dx > 0);
  edges.at_row[which] = dx * (Number(top) * kSubpixels - from.y) -
                        dy * (Number(left) * kSubpixels - from.x) - (takes_samples ? 0 : 1);
  edges.by_x[which] = -dy * kSubpixels;
  edges.by_y[which] = dx * kSubpixels;
  for (int s = 0; s < places.count; ++s)
    edges.of_sample[which][s] = dx * places.y[s] - dy * places.x[s];
}

template <typename Number>
[[gnu::always_inline]] static inline void fill_box(const FillTarget& target, const ScreenVertex& a,
                                                   const ScreenVertex& b, const ScreenVertex& c,
                                                   uint32_t id, int left, int top, int right,
                                                   int bottom) {
  const Number area =
      (Number(b.x) - a.x) * (Number(c.y) - a.y) - (Number(b.y) - a.y) * (Number(c.x) - a.x);
  if (area == 0) return;
  const ScreenVertex& second = area > 0 ? b : c;
  const ScreenVertex& third = area > 0 ? c : b;
  Edges<Number> edges;
  set_edge(edges, 0, second, third, left, top, target.places);
  set_edge(edges, 1, third, a, left, top, target.places);
  set_edge(edges, 2, a, second, left, top, target.places);
  const float per_area = 1 / static_cast<float>(area > 0 ? area : -area);
  const NearnessPlane plane{a.nearness, (second.nearness - a.nearness) * per_area,
                            (third.nearness - a.nearness) * per_area};
  const SampleKey low = static_cast<uint32_t>(~id);
  const int samples = target.places.count;
  for (int y = top; y <= bottom; ++y) {
    Number at[3] = {edges.at_row[0], edges.at_row[1], edges.at_row[2]};
    SampleKey* pixel = target.keys + (size_t(y) * target.width + left) * samples;
    for (int x = left; x <= right; ++x, pixel += samples) {
      for (int s = 0; s < samples; ++s) {
        const Number e0 = at[0] + edges.of_sample[0][s], e1 = at[1] + edges.of_sample[1][s],
                     e2 = at[2] + edges.of_sample[2][s];
        if ((e0 | e1 | e2) < 0) continue;
        const float nearness = plane.first + plane.by_second * static_cast<float>(e1) +
                               plane.by_third * static_cast<float>(e2);
        if (!(nearness > 0)) continue;  // past the far plane
        const auto bits = static_cast<SampleKey>(__builtin_bit_cast(uint32_t, nearness));
        show(pixel + s, bits << 32 | low, target.is_shared);
      }
      for (int e = 0; e < 3; ++e) at[e] += edges.by_x[e];
    }
    for (int e = 0; e < 3; ++e) edges.at_row[e] += edges.by_y[e];
  }
}

// Drops triangles that cover no sample. Scans have many that are smaller than a pixel.
[[gnu::always_inline]] static inline void fill_one(const FillTarget& target, const ScreenVertex& a,
                                                   const ScreenVertex& b, const ScreenVertex& c,
                                                   uint32_t id) {
  const int low_x = least(a.x, b.x, c.x), high_x = largest(a.x, b.x, c.x);
  const int low_y = least(a.y, b.y, c.y), high_y = largest(a.y, b.y, c.y);
  // The outermost samples of a pixel: 128 and 128, or 32 and 224.
  const int before = target.places.count == 1 ? 128 : 32;
  const int after = kSubpixels - before;
  const int left_at = (low_x + (kSubpixels - 1) - after) >> kSubpixelBits;
  const int right_at = (high_x - before) >> kSubpixelBits;
  if (left_at > right_at) return;
  const int top_at = (low_y + (kSubpixels - 1) - after) >> kSubpixelBits;
  const int bottom_at = (high_y - before) >> kSubpixelBits;
  if (top_at > bottom_at) return;
  const int left = left_at > target.first_column ? left_at : target.first_column;
  const int right = right_at < target.last_column ? right_at : target.last_column;
  const int top = top_at > 0 ? top_at : 0;
  const int bottom = bottom_at < target.last_row ? bottom_at : target.last_row;
  if (left > right || top > bottom) return;
  if (high_x - low_x < kSmallSubpixels && high_y - low_y < kSmallSubpixels) {
    fill_box<int32_t>(target, a, b, c, id, left, top, right, bottom);
  } else {
    fill_box<int64_t>(target, a, b, c, id, left, top, right, bottom);
  }
}

[[gnu::always_inline]] static inline int fill_each(const FillTarget& target,
                                                   const ScreenVertex* vertices,
                                                   const uint16_t* corners, int count,
                                                   uint32_t first_id, uint16_t* left) {
  int left_count = 0;
  for (int t = 0; t < count; ++t) {
    const ScreenVertex& a = vertices[corners[3 * t]];
    const ScreenVertex& b = vertices[corners[3 * t + 1]];
    const ScreenVertex& c = vertices[corners[3 * t + 2]];
    if (a.is_beyond | b.is_beyond | c.is_beyond) {
      left[left_count++] = static_cast<uint16_t>(t);
      continue;
    }
    fill_one(target, a, b, c, first_id + t);
  }
  return left_count;
}

// The numbers of samples and threads are constants in the loops.
BURNISH_DISPATCH
static int fill_all(FillTarget target, const ScreenVertex* vertices, const uint16_t* corners,
                    int count, uint32_t first_id, uint16_t* left) {
  if (target.places.count == 1) {
    target.places = kOneSample;
    if (target.is_shared) {
      target.is_shared = true;
      return fill_each(target, vertices, corners, count, first_id, left);
    }
    target.is_shared = false;
    return fill_each(target, vertices, corners, count, first_id, left);
  }
  target.places = kFourSamples;
  return fill_each(target, vertices, corners, count, first_id, left);
}

static FillTarget target_of(Visibility& visibility, const ColumnRange& columns, bool is_shared) {
  return {visibility.keys.data(),
          visibility.size.width,
          columns.first,
          columns.end - 1,
          visibility.size.height - 1,
          is_shared,
          sample_places(visibility.samples)};
}

int fill_triangles(Visibility& visibility, const ColumnRange& columns, bool is_shared,
                   const ScreenTriangles& triangles, uint16_t* left) {
  if (triangles.triangles.empty()) return 0;
  return fill_all(target_of(visibility, columns, is_shared), triangles.vertices,
                  triangles.triangles.front().data(), static_cast<int>(triangles.triangles.size()),
                  triangles.first_id, left);
}

void fill_triangle(Visibility& visibility, const ColumnRange& columns, bool is_shared,
                   const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c,
                   uint32_t id) {
  fill_one(target_of(visibility, columns, is_shared), a, b, c, id);
}

}  // namespace burnish
