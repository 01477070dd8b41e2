#include "server/solver/cpu/smoothers/paper/slice_rows.h"

#include <algorithm>

namespace burnish::cpu {

namespace {

struct Extent {
  int axis = 0;
  int first = 0;
  int count = 0;
};

Extent longest_extent(const SparseGrid& grid) {
  Vec3i least = Vec3i::Constant(1 << grid.depth), most = Vec3i::Zero();
  for (const GridKey& corner : grid.corners) {
    const Vec3i at = morton_point(corner.place);
    least = least.cwiseMin(at);
    most = most.cwiseMax(at);
  }
  int axis = 0;
  (most - least).maxCoeff(&axis);
  return {axis, least[axis], most[axis] - least[axis] + 1};
}

}  // namespace

SliceRows::SliceRows(const HierarchyDepth& topology) {
  const SparseGrid& grid = topology.grid;
  const Stencil& stencil = topology.stencil;
  const int32_t n = grid.corner_count();
  const Extent extent = longest_extent(grid);
  const auto slice_of = [&](int32_t i) {
    return morton_point(grid.corners[i].place)[extent.axis] - extent.first;
  };
  slice_start.assign(extent.count + 1, 0);
  for (int32_t i = 0; i < n; ++i) ++slice_start[slice_of(i) + 1];
  for (int s = 0; s < extent.count; ++s) slice_start[s + 1] += slice_start[s];

  std::vector<int32_t> next(slice_start.begin(), slice_start.end() - 1), place(n);
  corner.resize(n);
  for (int32_t i = 0; i < n; ++i) corner[place[i] = next[slice_of(i)]++] = i;
  row_start.assign(n + 1, 0);
  column.reserve(stencil.column.size());
  for (int32_t p = 0; p < n; ++p) {
    for (auto [k, end] = stencil.row(corner[p]); k < end; ++k)
      column.push_back(place[stencil.column[k]]);
    row_start[p + 1] = static_cast<int64_t>(column.size());
  }
  entry.resize(column.size());
  diagonal.resize(n);
  inverse_diagonal.resize(n);
}

void SliceRows::read(const CpuDepth& depth) {
  const int32_t n = depth.corner_count();
#pragma omp parallel for schedule(static)
  for (int32_t p = 0; p < n; ++p) {
    const int32_t from = corner[p];
    diagonal[p] = depth.system.diagonal[from];
    inverse_diagonal[p] = depth.inverse_diagonal[from];
    const auto [begin, end] = depth.topology.stencil.row(from);
    std::copy(depth.system.entry.begin() + begin, depth.system.entry.begin() + end,
              entry.begin() + row_start[p]);
  }
}

uint64_t SliceRows::byte_count() const {
  return bytes_of(slice_start) + bytes_of(corner) + bytes_of(row_start) + bytes_of(column) +
         bytes_of(entry) + bytes_of(diagonal) + bytes_of(inverse_diagonal);
}

std::vector<SliceRange> partition_slices(const SliceRows& rows, int count) {
  const int64_t corners = rows.slice_start.back();
  std::vector<SliceRange> ranges;
  int first = 0;
  for (int i = 1; i <= count; ++i) {
    const auto end = std::ranges::lower_bound(rows.slice_start, corners * i / count);
    const int last = static_cast<int>(end - rows.slice_start.begin());
    if (last > first) ranges.push_back({first, last});
    first = last;
  }
  return ranges;
}

}  // namespace burnish::cpu
