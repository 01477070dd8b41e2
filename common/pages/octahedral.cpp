#include "common/pages/octahedral.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

namespace burnish {

namespace {

constexpr int kSumBits = 21;

// Takes a point of the lower half from the square's middle to its corners, and back.
template <typename T>
std::array<T, 2> folded(T u, T v, T one) {
  return {u < 0 ? std::abs(v) - one : one - std::abs(v),
          v < 0 ? std::abs(u) - one : one - std::abs(u)};
}

int64_t size_of(const NormalSum& sum) {
  return std::abs(sum[0]) + std::abs(sum[1]) + std::abs(sum[2]);
}

}  // namespace

OctahedralCode octahedral_code(const Vec3f& direction, int limit) {
  const Vec3f on = direction / direction.lpNorm<1>();
  std::array<float, 2> place = {on.x(), on.y()};
  if (on.z() < 0) place = folded(on.x(), on.y(), 1.0f);
  const auto scale = static_cast<float>(limit);
  return {static_cast<int>(std::lround(place[0] * scale)),
          static_cast<int>(std::lround(place[1] * scale))};
}

Vec3f octahedral_normal(const OctahedralCode& code, int limit) {
  const auto scale = static_cast<float>(limit);
  std::array<float, 2> place = {static_cast<float>(code[0]) / scale,
                                static_cast<float>(code[1]) / scale};
  const float z = 1 - std::abs(place[0]) - std::abs(place[1]);
  if (z < 0) place = folded(place[0], place[1], 1.0f);
  return Vec3f(place[0], place[1], z).normalized();
}

OctahedralCode predicted_code(const NormalSum& sum) {
  const int shift =
      std::max(0, static_cast<int>(std::bit_width(static_cast<uint64_t>(size_of(sum)))) - kSumBits);
  const NormalSum small = {sum[0] >> shift, sum[1] >> shift, sum[2] >> shift};
  const auto size = static_cast<int>(size_of(small));
  if (size == 0) return {0, 0};
  const int u = static_cast<int>(small[0]) * kOctahedralLimit / size;
  const int v = static_cast<int>(small[1]) * kOctahedralLimit / size;
  return small[2] < 0 ? folded(u, v, kOctahedralLimit) : OctahedralCode{u, v};
}

}  // namespace burnish
