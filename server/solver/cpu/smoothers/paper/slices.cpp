#include <algorithm>

#include "common/base/parallel.h"
#include "server/solver/cpu/smoothers/paper/slice_rows.h"
#include "server/solver/cpu/smoothers/smoother.h"

namespace burnish::cpu {

namespace {

/// kBackwards is the reverse of kForwards: odd slices before even ones, a slice's corners from the
/// last.
enum class Order { kForwards, kBackwards };

/// The slices of one thread, and its own copy of x in them and in the slices around them.
struct Block {
  SliceRange own;
  SliceRange copied;
  int32_t first_place = 0;
  std::vector<Float4> x;
};

/// A sweep is two half-sweeps: the even slices, then the odd ones. (In a sweep from end to end each
/// slice would depend on all before it, and no overlap could make a block equal to the whole.)
class Slices final : public DepthSmoother {
 public:
  Slices(const HierarchyDepth& topology, const SliceOptions& options)
      : rows_(topology),
        half_sweeps_(2 * options.sweeps),
        temporal_blocking_(options.temporal_blocking) {
    const int count = options.blocks > 0 ? options.blocks : thread_count();
    for (const SliceRange& own : partition_slices(rows_, count)) {
      Block& block = blocks_.emplace_back();
      block.own = own;
      block.copied = widened(own, half_sweeps_);
      block.first_place = rows_.slice_start[block.copied.first];
      block.x.resize(rows_.slice_start[block.copied.last] - block.first_place);
    }
  }

  void set_up(CpuDepth& depth) override { rows_.read(depth); }

  void relax_from_zero(CpuDepth& depth) override {
    std::fill(depth.x.begin(), depth.x.end(), Float4::Zero());
    relax_blocks(depth, Order::kForwards);
  }

  void relax(CpuDepth& depth) override { relax_blocks(depth, Order::kBackwards); }

  uint64_t byte_count() const override {
    uint64_t bytes = rows_.byte_count();
    for (const Block& block : blocks_) bytes += bytes_of(block.x);
    return bytes;
  }

 private:
  SliceRange widened(SliceRange range, int by) const {
    return {std::max(range.first - by, 0), std::min(range.last + by, rows_.slice_count())};
  }

  void relax_blocks(CpuDepth& depth, Order order) {
#pragma omp parallel for schedule(static, 1)
    for (Block& block : blocks_) {
      for (size_t i = 0; i < block.x.size(); ++i)
        block.x[i] = depth.x[rows_.corner[block.first_place + i]];
      if (temporal_blocking_)
        sweep_in_a_window(depth, block, order);
      else
        sweep_by_sweep(depth, block, order);
    }
#pragma omp parallel for schedule(static, 1)
    for (const Block& block : blocks_)
      for (int32_t p = rows_.slice_start[block.own.first]; p < rows_.slice_start[block.own.last];
           ++p)
        depth.x[rows_.corner[p]] = block.x[p - block.first_place];
  }

  // Returns the slices that half-sweep h must relax, so that the block's own slices are right at
  // the end: one more slice on either side for each later half-sweep (Figure 4).
  SliceRange extent(const Block& block, int h) const {
    return widened(block.own, half_sweeps_ - 1 - h);
  }

  // Returns the parity of the slices that half-sweep h relaxes.
  static int parity(int h, Order order) {
    return (h + (order == Order::kBackwards)) & 1;
  }

  void sweep_by_sweep(const CpuDepth& depth, Block& block, Order order) const {
    for (int h = 0; h < half_sweeps_; ++h) {
      const SliceRange range = extent(block, h);
      for (int slice = range.first + ((range.first ^ parity(h, order)) & 1); slice < range.last;
           slice += 2)
        relax_slice(depth, block, slice, order);
    }
  }

  // Half-sweep h runs h slices behind the front. When it comes to a slice, half-sweep h − 1 has
  // just left both neighbours, and all of them are still in cache.
  void sweep_in_a_window(const CpuDepth& depth, Block& block, Order order) const {
    const SliceRange all = block.copied;
    for (int front = all.first + ((all.first ^ parity(0, order)) & 1);
         front < all.last + half_sweeps_; front += 2)
      for (int h = 0; h < half_sweeps_; ++h) {
        const SliceRange range = extent(block, h);
        const int slice = front - h;
        if (slice >= range.first && slice < range.last) relax_slice(depth, block, slice, order);
      }
  }

  void relax_slice(const CpuDepth& depth, Block& block, int slice, Order order) const {
    const int32_t first = rows_.slice_start[slice], last = rows_.slice_start[slice + 1];
    if (order == Order::kForwards)
      for (int32_t p = first; p < last; ++p) relax_place(depth, block, p);
    else
      for (int32_t p = last - 1; p >= first; --p) relax_place(depth, block, p);
  }

  void relax_place(const CpuDepth& depth, Block& block, int32_t p) const {
    Float4& here = block.x[p - block.first_place];
    Float4 sum = rows_.diagonal[p] * here;
    for (int64_t k = rows_.row_start[p]; k < rows_.row_start[p + 1]; ++k)
      sum += rows_.entry[k] * block.x[rows_.column[k] - block.first_place];
    here += rows_.inverse_diagonal[p] * (depth.f[rows_.corner[p]] - sum);
  }

  SliceRows rows_;
  std::vector<Block> blocks_;
  int half_sweeps_;
  bool temporal_blocking_;
};

}  // namespace

std::unique_ptr<DepthSmoother> make_slices(const HierarchyDepth& topology,
                                           const SliceOptions& options) {
  return std::make_unique<Slices>(topology, options);
}

}  // namespace burnish::cpu
