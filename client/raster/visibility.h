#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "client/scene/image.h"
#include "common/base/limits.h"

namespace burnish {

/// Names what a sample of the picture shows: nearness above, the triangle below. A larger one
/// covers a smaller one, so the picture is the same for any order of triangles.
using SampleKey = uint64_t;

inline constexpr SampleKey kNothingSeen = 0;
inline constexpr int kTriangleBits = 12;
static_assert(kPageTrianglesMax == 1u << kTriangleBits);

/// A triangle of the page in a slot.
inline constexpr uint32_t triangle_id(uint32_t slot, uint32_t triangle) {
  return slot << kTriangleBits | triangle;
}
inline constexpr uint32_t slot_of_id(uint32_t id) {
  return id >> kTriangleBits;
}
inline constexpr uint32_t triangle_of_id(uint32_t id) {
  return id & (kPageTrianglesMax - 1);
}

// The triangle with the smaller number is seen where two are at the same distance.
inline uint32_t id_of_key(SampleKey key) {
  return ~static_cast<uint32_t>(key);
}
inline float nearness_of_key(SampleKey key) {
  return std::bit_cast<float>(static_cast<uint32_t>(key >> 32));
}

inline constexpr int kSamplesMax = 4;

/// Places of a pixel's samples: subpixels from its upper left corner. Four lie as OpenGL's
/// drivers have them.
struct SamplePlaces {
  int count;
  int x[kSamplesMax], y[kSamplesMax];
};

inline constexpr SamplePlaces kOneSample{1, {128, 128, 128, 128}, {128, 128, 128, 128}};
inline constexpr SamplePlaces kFourSamples{4, {96, 224, 32, 160}, {224, 160, 96, 32}};

inline const SamplePlaces& sample_places(int samples) {
  return samples == 1 ? kOneSample : kFourSamples;
}

/// Keeps what every sample of a picture shows, pixel by pixel in rows from above.
struct Visibility {
  ImageSize size;
  int samples = 1;
  std::vector<SampleKey> keys;

  size_t place(int x, int y) const { return (size_t(y) * size.width + x) * samples; }
};

}  // namespace burnish
