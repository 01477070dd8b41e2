#include "server/prepare/curvature_average.h"

#include <algorithm>
#include <utility>

#include "common/grid/morton.h"

namespace burnish {

static constexpr double kBucketsPerSideMax = 1 << 20;  // what a Morton key holds, with a margin

namespace {

// The vertices that have area, by cubes as wide as the radius: neighbours lie in the 27 around.
class Buckets {
 public:
  Buckets(const TriangleMesh& mesh, const MeshStatistics& statistics,
          const VertexCurvature& vertices, double radius)
      : origin_(statistics.box_min),
        width_(std::max(radius, statistics.diagonal() / kBucketsPerSideMax)) {
    for (size_t v = 0; v < mesh.vertices.size(); ++v) {
      if (vertices.areas[v] > 0)
        entries_.emplace_back(morton_key(bucket_of(mesh.vertices[v])), static_cast<uint32_t>(v));
    }
    std::sort(entries_.begin(), entries_.end());
  }

  template <typename Visit>
  void for_each_near(const Vec3d& p, Visit visit) const {
    const Vec3i home = bucket_of(p);
    for (int i = 0; i < 27; ++i) {
      const Vec3i bucket = home + Vec3i(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      if (bucket.minCoeff() < 0) continue;
      const MortonKey key = morton_key(bucket);
      auto entry = std::lower_bound(entries_.begin(), entries_.end(), std::pair(key, 0u));
      for (; entry != entries_.end() && entry->first == key; ++entry) visit(entry->second);
    }
  }

 private:
  Vec3i bucket_of(const Vec3d& p) const {
    return ((p - origin_) / width_).array().floor().cast<int>();
  }

  Vec3d origin_;
  double width_;
  std::vector<std::pair<MortonKey, uint32_t>> entries_;
};

}  // namespace

std::vector<TangentTensor> average_tensors(const TriangleMesh& mesh,
                                           const MeshStatistics& statistics,
                                           const VertexCurvature& vertices, double radius) {
  const Buckets buckets(mesh, statistics, vertices, radius);
  std::vector<TangentTensor> averages(mesh.vertices.size());
#pragma omp parallel for schedule(dynamic, 1024)
  for (int64_t v = 0; v < static_cast<int64_t>(averages.size()); ++v) {
    if (!(vertices.areas[v] > 0)) continue;
    const TangentFrame frame = make_frame(vertices.normals[v]);
    TangentTensor sum;
    double area = 0;
    buckets.for_each_near(mesh.vertices[v], [&](uint32_t w) {
      if ((mesh.vertices[w] - mesh.vertices[v]).squaredNorm() > radius * radius) return;
      if (vertices.normals[w].dot(frame.normal) <= 0) return;
      const TangentFrame from = make_frame(vertices.normals[w]);
      sum.add(vertices.areas[w], carry_tensor(vertices.tensors[w], from, frame));
      area += vertices.areas[w];
    });
    averages[v] = sum.scaled(1 / area);
  }
  return averages;
}

}  // namespace burnish
