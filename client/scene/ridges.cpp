#include "client/scene/ridges.h"

#include <cmath>

namespace burnish {

static constexpr int kRidgeAveragingPasses = 2;
static constexpr float kRidgeCurvature = 60;  // per unit; gives a ridge of 0.5

namespace {

struct EdgeSum {
  float value = 0;
  float weight = 0;
};

}  // namespace

// Weighs edges by squared length. Otherwise the shortest edges of slivers would decide.
template <typename Corners>
static std::vector<float> divergences(std::span<const Vec3f> positions,
                                      std::span<const Vec3f> normals,
                                      std::span<const Corners> triangles) {
  std::vector<EdgeSum> sums(positions.size());
  for (const Corners& triangle : triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      const auto from = triangle[corner], to = triangle[(corner + 1) % 3];
      const Vec3f edge = positions[to] - positions[from];
      const float value = (normals[to] - normals[from]).dot(edge);
      const float weight = edge.squaredNorm();
      for (const auto end : {from, to}) {
        sums[end].value += value;
        sums[end].weight += weight;
      }
    }
  }
  std::vector<float> means(positions.size());
  for (size_t v = 0; v < means.size(); ++v)
    if (sums[v].weight > 0) means[v] = sums[v].value / sums[v].weight;
  return means;
}

// Takes the middle between each vertex and the mean of its neighbours.
template <typename Corners>
static void average(std::span<const Corners> triangles, std::vector<float>& ridges) {
  std::vector<EdgeSum> sums(ridges.size());
  for (const Corners& triangle : triangles) {
    const float all = ridges[triangle[0]] + ridges[triangle[1]] + ridges[triangle[2]];
    for (const auto vertex : triangle) {
      sums[vertex].value += all - ridges[vertex];
      sums[vertex].weight += 2;
    }
  }
  for (size_t v = 0; v < ridges.size(); ++v)
    if (sums[v].weight > 0) ridges[v] = (ridges[v] + sums[v].value / sums[v].weight) / 2;
}

template <typename Corners>
static std::vector<float> ridges_of(std::span<const Vec3f> positions,
                                    std::span<const Vec3f> normals,
                                    std::span<const Corners> triangles) {
  std::vector<float> ridges = divergences(positions, normals, triangles);
  for (int pass = 0; pass < kRidgeAveragingPasses; ++pass) average(triangles, ridges);
  for (float& ridge : ridges) ridge /= kRidgeCurvature + std::abs(ridge);
  return ridges;
}

std::vector<float> vertex_ridges(std::span<const Vec3f> positions, std::span<const Vec3f> normals,
                                 std::span<const Triangle> triangles) {
  return ridges_of(positions, normals, triangles);
}

std::vector<float> vertex_ridges(std::span<const Vec3f> positions, std::span<const Vec3f> normals,
                                 std::span<const PageTriangle> triangles) {
  return ridges_of(positions, normals, triangles);
}

}  // namespace burnish
