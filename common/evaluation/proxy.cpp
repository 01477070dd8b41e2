#include "common/evaluation/proxy.h"

#include <algorithm>
#include <bit>
#include <meshoptimizer.h>

#include "common/base/check.h"

namespace burnish {

namespace {

constexpr float kAnyError = 1;  // of the mesh's extent: only the count decides

using Indices = std::vector<unsigned int>;

// Returns positions relative to the first vertex: surveys lie far from the origin, where floats are
// coarse.
std::vector<Vec3f> float_positions(std::span<const Vec3d> vertices) {
  std::vector<Vec3f> positions;
  positions.reserve(vertices.size());
  for (const Vec3d& vertex : vertices) positions.emplace_back((vertex - vertices[0]).cast<float>());
  return positions;
}

Indices simplify(const Indices& indices, const std::vector<Vec3f>& positions, size_t index_max) {
  Indices fewer(indices.size());
  fewer.resize(meshopt_simplify(fewer.data(), indices.data(), indices.size(), positions[0].data(),
                                positions.size(), sizeof(Vec3f), index_max, kAnyError, 0, nullptr));
  if (fewer.size() <= index_max) return fewer;
  Indices clustered(fewer.size());
  clustered.resize(meshopt_simplifySloppy(clustered.data(), fewer.data(), fewer.size(),
                                          positions[0].data(), positions.size(), sizeof(Vec3f),
                                          index_max, kAnyError, nullptr));
  return clustered;
}

Proxy of_indices(const Indices& indices, std::span<const EvaluationPoint> evaluation) {
  constexpr uint32_t kUnseen = ~uint32_t{0};
  std::vector<uint32_t> number(evaluation.size(), kUnseen);
  Proxy proxy;
  for (size_t i = 0; i < indices.size(); i += 3) {
    Triangle triangle;
    for (int corner = 0; corner < 3; ++corner) {
      const uint32_t vertex = indices[i + corner];
      if (number[vertex] == kUnseen) {
        number[vertex] = static_cast<uint32_t>(proxy.source.size());
        proxy.source.push_back(vertex);
        proxy.evaluation.push_back(evaluation[vertex]);
      }
      triangle[corner] = number[vertex];
    }
    proxy.triangles.push_back(triangle);
  }
  return proxy;
}

}  // namespace

Proxy make_proxy(const DetailedMesh& mesh, size_t triangles_max) {
  BURNISH_CHECK(triangles_max > 0, "a proxy has triangles");
  Indices indices;
  indices.reserve(mesh.triangles.size() * 3);
  for (const Triangle& triangle : mesh.triangles)
    indices.insert(indices.end(), triangle.begin(), triangle.end());
  if (mesh.triangles.size() > triangles_max)
    indices = simplify(indices, float_positions(mesh.vertices), triangles_max * 3);
  return of_indices(indices, mesh.evaluation);
}

uint64_t rounded_triangles_max(uint64_t triangles_max) {
  constexpr uint64_t kLeast = 1000;
  if (triangles_max == 0) return 0;
  const int dropped_bits = std::max(static_cast<int>(std::bit_width(triangles_max)) - 2, 0);
  return std::max(triangles_max >> dropped_bits << dropped_bits, kLeast);
}

}  // namespace burnish
