#include "client/scene/spatial_order.h"

#include <algorithm>
#include <span>

#include "common/grid/morton.h"

namespace burnish {

static constexpr int kAxisBits = 10;
static constexpr int kDigitBits = 10;  // three digits: the counts fit in the nearest cache
static constexpr uint32_t kDigits = 1u << kDigitBits;

namespace {

struct KeyedTriangle {
  uint32_t key;
  uint32_t triangle;
};

}  // namespace

static std::vector<KeyedTriangle> keyed_triangles(const TriangleMesh& mesh,
                                                  const Eigen::AlignedBox3d& box) {
  const double cells = 1 << kAxisBits;
  const double scale = cells / (3 * box.sizes().maxCoeff());
  std::vector<KeyedTriangle> keyed;
  keyed.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    Vec3d sum = -3 * box.min();
    for (const uint32_t vertex : {a, b, c}) sum += mesh.vertices[vertex];
    const Vec3i cell = (scale * sum).cwiseMin(cells - 1).cwiseMax(0).cast<int>();
    keyed.push_back({static_cast<uint32_t>(morton_key(cell)), static_cast<uint32_t>(keyed.size())});
  }
  return keyed;
}

// Sorts by one digit and keeps the order of equal digits.
static void sort_by_digit(std::span<const KeyedTriangle> from, std::span<KeyedTriangle> to,
                          int shift) {
  const auto digit = [shift](const KeyedTriangle& each) {
    return each.key >> shift & (kDigits - 1);
  };
  std::vector<uint32_t> next(kDigits + 1);
  for (const KeyedTriangle& each : from) ++next[digit(each) + 1];
  for (uint32_t i = 1; i <= kDigits; ++i) next[i] += next[i - 1];
  for (const KeyedTriangle& each : from) to[next[digit(each)]++] = each;
}

std::vector<uint32_t> spatial_order(const TriangleMesh& mesh, const Eigen::AlignedBox3d& box) {
  std::vector<KeyedTriangle> keyed = keyed_triangles(mesh, box), sorted(keyed.size());
  for (int shift = 0; shift < 3 * kAxisBits; shift += kDigitBits) {
    sort_by_digit(keyed, sorted, shift);
    std::swap(keyed, sorted);
  }
  std::vector<uint32_t> order;
  order.reserve(keyed.size());
  for (const KeyedTriangle& each : keyed) order.push_back(each.triangle);
  return order;
}

}  // namespace burnish
