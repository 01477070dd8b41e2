#include "server/prepare/piece_count.h"

#include <algorithm>
#include <atomic>
#include <string>

#include "common/base/loop_progress.h"
#include "common/base/parallel.h"
#include "common/grid/morton.h"
#include "server/prepare/cut_triangles.h"

namespace burnish {

namespace {

constexpr int kBucketLevelsMax = 6;

/// Counts the pieces of one block. Neighbours mostly lie in one bucket: they are added to it
/// together.
class BucketTally {
 public:
  BucketTally(std::vector<uint64_t>& counts, int levels_below)
      : counts_(counts), levels_below_(levels_below) {}
  ~BucketTally() { flush(); }

  void add(const CellColumn& column) {
    for (int k = column.k.first; k <= column.k.last;) {
      const int bucket_k = k >> levels_below_;
      const int end = std::min(column.k.last + 1, (bucket_k + 1) << levels_below_);
      move_to({column.i >> levels_below_, column.j >> levels_below_, bucket_k});
      waiting_ += static_cast<uint64_t>(end - k);
      total_ += static_cast<uint64_t>(end - k);
      k = end;
    }
  }
  uint64_t total() const { return total_; }

 private:
  void move_to(const Vec3i& bucket) {
    if (bucket == bucket_) return;
    flush();
    bucket_ = bucket;
  }
  void flush() {
    if (waiting_ == 0) return;
    std::atomic_ref(counts_[morton_key(bucket_) + 1]).fetch_add(waiting_);
    waiting_ = 0;
  }

  std::vector<uint64_t>& counts_;
  const int levels_below_;
  Vec3i bucket_ = Vec3i::Zero();
  uint64_t waiting_ = 0;
  uint64_t total_ = 0;
};

}  // namespace

Result<PieceCount> count_cell_pieces(const GridMesh& mesh, uint64_t pieces_max,
                                     const Progress& progress) {
  const int levels = std::min(mesh.depth, kBucketLevelsMax), levels_below = mesh.depth - levels;
  PieceCount count{3 * levels_below, std::vector<uint64_t>((size_t{1} << 3 * levels) + 1, 0)};
  std::atomic<uint64_t> total{0};
  std::atomic<size_t> done{0};  // blocks
  const auto blocks = static_cast<double>(block_count(mesh));
  LoopProgress loop(progress, "grid", 0, kCountedPart);
  ParallelFailure failure;
  if (!loop.goes_on(0)) return cancelled("cancelled while counting pieces");
#pragma omp parallel for schedule(dynamic)
  for (size_t block = 0; block < block_count(mesh); ++block) {
    if (total > pieces_max || loop.is_cancelled()) continue;
    failure.run([&] {
      BucketTally tally(count.start, levels_below);
      for_each_triangle_of_block(mesh, block, [&](const CutTriangle& triangle) {
        for (const CellColumn& column : triangle.columns) tally.add(column);
        return tally.total() <= pieces_max && loop.goes_on(static_cast<double>(done) / blocks);
      });
      total += tally.total();
    });
    ++done;
  }
  failure.rethrow();
  if (loop.is_cancelled()) return cancelled("cancelled while counting pieces");
  if (total > pieces_max)
    return resource_exhausted("cutting the scan at this depth gives more than " +
                              std::to_string(pieces_max) + " pieces");
  for (size_t bucket = 1; bucket < count.start.size(); ++bucket)
    count.start[bucket] += count.start[bucket - 1];
  return count;
}

Bricks make_bricks(const PieceCount& count, uint64_t pieces_max) {
  Bricks bricks;
  bricks.of_bucket.resize(count.start.size() - 1);
  bricks.start = {0};
  for (size_t bucket = 0; bucket < bricks.of_bucket.size(); ++bucket) {
    const uint64_t begin = count.start[bucket], end = count.start[bucket + 1];
    if (begin > bricks.start.back() && end - bricks.start.back() > pieces_max)
      bricks.start.push_back(begin);
    bricks.of_bucket[bucket] = static_cast<uint32_t>(bricks.start.size() - 1);
  }
  bricks.start.push_back(count.total());
  return bricks;
}

}  // namespace burnish
