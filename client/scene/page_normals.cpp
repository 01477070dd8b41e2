#include "client/scene/page_normals.h"

#include <cmath>
#include <limits>

#include "common/base/dispatch.h"

namespace burnish {

static constexpr float kOpposite = 1e-3f;  // 1 + cosine

namespace {

constexpr int kLanes = 8;  // triangles that are summed side by side

/// Three vectors for each of several triangles.
struct Corners {
  float x[3][kLanes], y[3][kLanes], z[3][kLanes];
};

struct Vector {
  float x, y, z;
};

}  // namespace

[[gnu::always_inline]] static inline Vector edge(const Corners& corners, int from, int to,
                                                 int lane) {
  return {corners.x[to][lane] - corners.x[from][lane], corners.y[to][lane] - corners.y[from][lane],
          corners.z[to][lane] - corners.z[from][lane]};
}

[[gnu::always_inline]] static inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

[[gnu::always_inline]] static inline float dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

[[gnu::always_inline]] static inline float length_of(const Vector& vector) {
  return __builtin_sqrtf(dot(vector, vector));
}

// Replaces the positions of corners by the corners' normals (common/mesh/corner_normals.h).
[[gnu::always_inline]] static inline void weigh(Corners& corners, int lane) {
  constexpr float kTiny = std::numeric_limits<float>::min();
  const Vector to_b = edge(corners, 0, 1, lane), to_c = edge(corners, 0, 2, lane);
  const Vector across = cross(to_b, to_c);
  const float ab = length_of(to_b), ac = length_of(to_c);
  const float bc = length_of(edge(corners, 1, 2, lane));
  const float sides[3] = {ab * ac, ab * bc, ac * bc};
  float weights[3];
  for (int corner = 0; corner < 3; ++corner)
    weights[corner] = sides[corner] > kTiny ? 1 / sides[corner] : 0;
#pragma GCC unroll 3
  for (int corner = 0; corner < 3; ++corner) {
    corners.x[corner][lane] = across.x * weights[corner];
    corners.y[corner][lane] = across.y * weights[corner];
    corners.z[corner][lane] = across.z * weights[corner];
  }
}

// Lanes behind the last triangle repeat the first one; their sums are not added.
[[gnu::always_inline]] static inline void read(const float* positions, const uint16_t* triangles,
                                               int count, Corners& corners) {
  for (int lane = 0; lane < kLanes; ++lane) {
#pragma GCC unroll 3
    for (int corner = 0; corner < 3; ++corner) {
      const float* at = positions + 3 * triangles[3 * (lane < count ? lane : 0) + corner];
      corners.x[corner][lane] = at[0];
      corners.y[corner][lane] = at[1];
      corners.z[corner][lane] = at[2];
    }
  }
}

[[gnu::always_inline]] static inline void add(const Corners& normals, const uint16_t* triangles,
                                              int count, float* sums) {
  for (int lane = 0; lane < count; ++lane) {
#pragma GCC unroll 3
    for (int corner = 0; corner < 3; ++corner) {
      float* const sum = sums + 3 * triangles[3 * lane + corner];
      sum[0] += normals.x[corner][lane];
      sum[1] += normals.y[corner][lane];
      sum[2] += normals.z[corner][lane];
    }
  }
}

BURNISH_DISPATCH
static void sum_all(const float* positions, const uint16_t* triangles, int count, float* sums) {
  for (int first = 0; first < count; first += kLanes) {
    const int lanes = count - first < kLanes ? count - first : kLanes;
    Corners corners;
    read(positions, triangles + 3 * first, lanes, corners);
    for (int lane = 0; lane < kLanes; ++lane) weigh(corners, lane);
    add(corners, triangles + 3 * first, lanes, sums);
  }
}

std::vector<Vec3f> sum_corner_normals(std::span<const Vec3f> positions,
                                      std::span<const PageTriangle> triangles) {
  std::vector<Vec3f> sums(positions.size(), Vec3f::Zero());
  if (triangles.empty()) return sums;
  sum_all(positions.front().data(), triangles.front().data(), static_cast<int>(triangles.size()),
          sums.front().data());
  return sums;
}

Vec3f turned_normal(const Vec3f& normal, const Vec3f& from, const Vec3f& to) {
  if (from == to || from.isZero(0) || to.isZero(0)) return normal;
  const Vec3f a = from.normalized(), b = to.normalized();
  const float nearness = 1 + a.dot(b);
  if (nearness < kOpposite) return b;
  const Vec3f sum = a + b;
  return (normal - (sum.dot(normal) / nearness) * sum + 2 * a.dot(normal) * b).normalized();
}

}  // namespace burnish
