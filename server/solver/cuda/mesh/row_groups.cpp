#include "server/solver/cuda/mesh/row_groups.h"

#include <algorithm>

#include "common/base/sort_once.h"
#include "server/solver/cuda/device/views.h"
#include "server/solver/cuda/mesh/long_rows.h"

namespace burnish::cuda {

namespace {

static_assert(kSliceRows * (kEntriesMax + 1) <= kTile);

struct Group {
  int32_t begin, end;
  std::vector<int32_t> halo;
  int32_t tile() const { return end - begin + static_cast<int32_t>(halo.size()); }
  bool fits() const { return tile() <= kTile; }
};

Group group_of(const Stencil& stencil, int32_t begin, int32_t end) {
  Group group = {begin, end, {}};
  for (int32_t i = begin; i < end; ++i)
    for (auto [k, stop] = packed_part(stencil, i); k < stop; ++k)
      if (const int32_t column = stencil.column[k]; column < begin || column >= end)
        group.halo.push_back(column);
  sort_once(group.halo);
  return group;
}

std::vector<Group> groups_of(const Stencil& stencil, int32_t rows) {
  const auto n = static_cast<int32_t>(stencil.mask.size());
  std::vector<Group> groups((n + rows - 1) / rows);
#pragma omp parallel for schedule(static)
  for (size_t g = 0; g < groups.size(); ++g) {
    const int32_t begin = static_cast<int32_t>(g) * rows;
    groups[g] = group_of(stencil, begin, std::min(n, begin + rows));
  }
  return groups;
}

uint16_t local_of(const Group& group, int32_t column) {
  if (column >= group.begin && column < group.end)
    return static_cast<uint16_t>(column - group.begin);
  const auto at = std::ranges::lower_bound(group.halo, column) - group.halo.begin();
  return static_cast<uint16_t>(group.end - group.begin + at);
}

}  // namespace

std::vector<int64_t> slice_starts(const Stencil& stencil) {
  const auto n = static_cast<int32_t>(stencil.mask.size());
  std::vector<int64_t> starts((n + kSliceRows - 1) / kSliceRows + 1, 0);
#pragma omp parallel for schedule(static)
  for (int32_t first = 0; first < n; first += kSliceRows) {
    int64_t& longest = starts[first / kSliceRows + 1];
    for (int32_t i = first; i < std::min(n, first + kSliceRows); ++i) {
      const Stencil::Row row = packed_part(stencil, i);
      longest = std::max<int64_t>(longest, row.end - row.begin);
    }
  }
  for (size_t slice = 1; slice < starts.size(); ++slice)
    starts[slice] = starts[slice - 1] + starts[slice] * kSliceRows;
  return starts;
}

RowGroups make_row_groups(const Stencil& stencil, const std::vector<int64_t>& starts) {
  RowGroups result;
  result.rows = 4 * kSliceRows;
  std::vector<Group> groups = groups_of(stencil, result.rows);
  if (!std::ranges::all_of(groups, &Group::fits)) {
    result.rows = kSliceRows;
    groups = groups_of(stencil, result.rows);
  }
  result.local.resize(starts.back());
#pragma omp parallel for schedule(static)
  for (size_t g = 0; g < groups.size(); ++g)
    for (int32_t i = groups[g].begin; i < groups[g].end; ++i) {
      int64_t to = starts[i / kSliceRows] + i % kSliceRows;
      for (auto [k, end] = packed_part(stencil, i); k < end; ++k, to += kSliceRows)
        result.local[to] = local_of(groups[g], stencil.column[k]);
    }
  result.halo_start = {0};
  result.tile_max = 0;
  for (const Group& group : groups) {
    result.tile_max = std::max(result.tile_max, group.tile());
    result.halo.insert(result.halo.end(), group.halo.begin(), group.halo.end());
    result.halo_start.push_back(static_cast<int32_t>(result.halo.size()));
  }
  return result;
}

}  // namespace burnish::cuda
