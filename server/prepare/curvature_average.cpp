#include "server/prepare/curvature_average.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "common/grid/morton.h"

namespace burnish {

static constexpr double kBucketsPerSideMax = 1 << 17;  // the range of a Morton key, with a margin
static constexpr int kSplitsOfBucket = 3;              // sorts vertices by eighths of a bucket
static constexpr size_t kSamplesPerBucket = 32;

namespace {

/// A vertex that stands for itself and the next few vertices in its bucket.
struct Sample {
  MortonKey bucket;
  uint32_t vertex;
  double weight;
};

bool operator<(const Sample& sample, MortonKey bucket) {
  return sample.bucket < bucket;
}

/// The vertices with area, in cubes as wide as the radius: neighbours lie in the 27 cubes around.
class Buckets {
 public:
  Buckets(const MeshView& mesh, const MeshStatistics& statistics, const VertexCurvature& vertices,
          double radius, const ScratchSpace& space, const LoopPart& part)
      : origin_(statistics.box_min),
        width_(std::max(radius, statistics.diagonal() / kBucketsPerSideMax)) {
    const Order order = sort_vertices(mesh, vertices, space, part);
    size_t samples = 0;
    for_each_sample(order, [&](size_t, size_t) { ++samples; });
    samples_ = ScratchArray<Sample>(space, samples);
    size_t next = 0;
    for_each_sample(order, [&](size_t i, size_t stands_for) {
      const auto& [fine_bucket, v] = order[i];
      samples_[next++] = {fine_bucket >> 3 * kSplitsOfBucket, v,
                          vertices.areas[v] * static_cast<double>(stands_for)};
    });
  }

  template <typename Visit>
  void for_each_near(const Vec3d& p, Visit visit) const {
    const Vec3i home = cube_of(p, width_);
    for (int i = 0; i < 27; ++i) {
      const Vec3i cube = home + Vec3i(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      if (cube.minCoeff() < 0) continue;
      const MortonKey bucket = morton_key(cube);
      auto sample = std::lower_bound(samples_.begin(), samples_.end(), bucket);
      for (; sample != samples_.end() && sample->bucket == bucket; ++sample) visit(*sample);
    }
  }

 private:
  using Order = ScratchArray<std::pair<MortonKey, uint32_t>>;  // by eighths of buckets

  Order sort_vertices(const MeshView& mesh, const VertexCurvature& vertices,
                      const ScratchSpace& space, const LoopPart& part) const {
    Order order(space, mesh.vertices.size());
    const double fine_width = width_ / (1 << kSplitsOfBucket);
    size_t count = 0;
    for_each_heard(part.of(0, 0.2), mesh.vertices.size(), [&](size_t v) {
      if (vertices.areas[v] > 0)
        order[count++] = {morton_key(cube_of(mesh.vertices[v], fine_width)),
                          static_cast<uint32_t>(v)};
    });
    order.truncate(count);
    sort_heard(part.of(0.2, 1), order.begin(), order.end(), std::less<>());
    return order;
  }

  // Calls visit(place in the order, number of vertices that it stands for).
  template <typename Visit>
  static void for_each_sample(const Order& order, Visit visit) {
    for (size_t begin = 0, end = 0; begin < order.size(); begin = end) {
      const MortonKey bucket = order[begin].first >> 3 * kSplitsOfBucket;
      while (end < order.size() && order[end].first >> 3 * kSplitsOfBucket == bucket) ++end;
      const size_t stride = (end - begin + kSamplesPerBucket - 1) / kSamplesPerBucket;
      for (size_t i = begin; i < end; i += stride) visit(i, std::min(stride, end - i));
    }
  }

  Vec3i cube_of(const Vec3d& p, double width) const {
    return ((p - origin_) / width).array().floor().cast<int>();
  }

  Vec3d origin_;
  double width_;
  ScratchArray<Sample> samples_;
};

}  // namespace

ScratchArray<TangentTensor> average_tensors(const MeshView& mesh, const MeshStatistics& statistics,
                                            const VertexCurvature& vertices, double radius,
                                            const ScratchSpace& space, const LoopPart& part) {
  const Buckets buckets(mesh, statistics, vertices, radius, space, part.of(0, 0.2));
  ScratchArray<TangentTensor> averages = copy_to(space, vertices.tensors);
  parallel_for_heard(part.of(0.2, 1), averages.size(), [&](size_t v) {
    if (!(vertices.areas[v] > 0)) return;
    const TangentFrame frame = make_frame(vertices.normals[v]);
    TangentTensor sum;
    double weight = 0;
    buckets.for_each_near(mesh.vertices[v], [&](const Sample& sample) {
      if ((mesh.vertices[sample.vertex] - mesh.vertices[v]).squaredNorm() > radius * radius) return;
      const Vec3d& normal = vertices.normals[sample.vertex];
      if (normal.dot(frame.normal) <= 0) return;
      sum.add(sample.weight,
              carry_tensor(vertices.tensors[sample.vertex], make_frame(normal), frame));
      weight += sample.weight;
    });
    if (weight > 0) averages[v] = sum.scaled(1 / weight);
  });
  return averages;
}

}  // namespace burnish
