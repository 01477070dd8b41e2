#include "server/prepare/pages/triangle_runs.h"

#include <cmath>

#include "common/grid/morton.h"

namespace burnish {

namespace {

constexpr int kBucketBitsPerAxis = 5;
constexpr double kGoldenFraction = 0.6180339887498949;

TriangleCentre centre_of(const LevelToCut& level, size_t triangle) {
  Vec3i sum = Vec3i::Zero();
  for (const uint32_t v : level.triangles[triangle]) sum += level.positions[v];
  return {{sum.x(), sum.y(), sum.z()}, static_cast<uint32_t>(triangle)};
}

/// Counts along a Morton curve over a cube twice as wide as the grid's, in which the grid's cube is
/// moved by another fraction of its side at every level.
class BucketCurve {
 public:
  explicit BucketCurve(const LevelToCut& level)
      : shift_(level.bits + 1 - kBucketBitsPerAxis),
        offset_(static_cast<int32_t>(std::fmod(level.level * kGoldenFraction, 1.0) *
                                     (1 << level.bits))) {}

  size_t bucket_of(const TriangleCentre& centre) const {
    const auto cell = [&](int axis) { return (centre.at[axis] / 3 + offset_) >> shift_; };
    return morton_key({cell(0), cell(1), cell(2)});
  }
  static constexpr size_t kBuckets = size_t{1} << (3 * kBucketBitsPerAxis);

 private:
  int shift_;
  int32_t offset_;
};

}  // namespace

TriangleRuns make_triangle_runs(const LevelToCut& level, const ScratchSpace& space,
                                const LoopPart& part) {
  const size_t count = level.triangles.size();
  TriangleRuns runs;
  runs.centres = ScratchArray<TriangleCentre>(space, count);
  runs.starts = {0};
  if (count <= kTrianglesPerRun) {
#pragma omp parallel for schedule(static)
    for (size_t t = 0; t < count; ++t) runs.centres[t] = centre_of(level, t);
    runs.starts.push_back(count);
    return runs;
  }

  const BucketCurve curve(level);
  ScratchArray<uint16_t> bucket(space, count);
  parallel_for_heard(part, count, [&](size_t t) {
    bucket[t] = static_cast<uint16_t>(curve.bucket_of(centre_of(level, t)));
  });
  std::vector<uint64_t> next(BucketCurve::kBuckets + 1);
  for_each_heard(part, count, [&](size_t t) { ++next[bucket[t] + 1]; });
  for (size_t b = 0; b < BucketCurve::kBuckets; ++b) {
    next[b + 1] += next[b];
    if (next[b + 1] - runs.starts.back() >= kTrianglesPerRun || next[b + 1] == count)
      if (runs.starts.back() != next[b + 1]) runs.starts.push_back(next[b + 1]);
  }
  for_each_heard(part, count,
                 [&](size_t t) { runs.centres[next[bucket[t]]++] = centre_of(level, t); });
  return runs;
}

}  // namespace burnish
