#include "server/solver/cuda/row_groups.h"

#include <algorithm>

#include "server/solver/cuda/packed.h"
#include "server/solver/cuda/views.h"

namespace burnish::cuda {

namespace {

constexpr int32_t kWindowRows = 4 * kSliceRows;  // as many as a block has threads
static_assert(kSliceRows * 27 <= kTile);

struct Group {
  int32_t begin, end;
  std::vector<int32_t> halo;
  bool fits() const { return end - begin + halo.size() <= kTile; }
};

Group group_of(const Stencil& stencil, int32_t begin, int32_t end) {
  Group group = {begin, end, {}};
  for (int32_t i = begin; i < end; ++i)
    for (auto [k, stop] = stencil.row(i); k < stop; ++k)
      if (const int32_t column = stencil.column[k]; column < begin || column >= end)
        group.halo.push_back(column);
  std::ranges::sort(group.halo);
  group.halo.erase(std::unique(group.halo.begin(), group.halo.end()), group.halo.end());
  return group;
}

std::vector<Group> groups_of_window(const Stencil& stencil, int32_t begin, int32_t end) {
  std::vector<Group> groups = {group_of(stencil, begin, end)};
  if (groups[0].fits()) return groups;
  groups.clear();
  for (int32_t slice = begin; slice < end; slice += kSliceRows)
    groups.push_back(group_of(stencil, slice, std::min(end, slice + kSliceRows)));
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
  std::vector<int64_t> starts = {0};
  for (int32_t first = 0; first < n; first += kSliceRows) {
    int longest = 0;
    for (int32_t i = first; i < std::min(n, first + kSliceRows); ++i)
      longest = std::max(longest, __builtin_popcount(stencil.mask[i]));
    starts.push_back(starts.back() + longest * kSliceRows);
  }
  return starts;
}

RowGroups make_row_groups(const Stencil& stencil, const std::vector<int64_t>& starts) {
  const auto n = static_cast<int32_t>(stencil.mask.size());
  const int32_t windows = (n + kWindowRows - 1) / kWindowRows;
  std::vector<std::vector<Group>> groups(windows);
  RowGroups result;
  result.local.resize(starts.back());
#pragma omp parallel for schedule(static)
  for (int32_t w = 0; w < windows; ++w) {
    const int32_t begin = w * kWindowRows;
    groups[w] = groups_of_window(stencil, begin, std::min(n, begin + kWindowRows));
    for (const Group& group : groups[w])
      for (int32_t i = group.begin; i < group.end; ++i) {
        int64_t to = starts[i / kSliceRows] + i % kSliceRows;
        for (auto [k, end] = stencil.row(i); k < end; ++k, to += kSliceRows)
          result.local[to] = local_of(group, stencil.column[k]);
      }
  }
  for (const auto& of_window : groups)
    for (const Group& group : of_window) {
      result.first_row.push_back(group.begin);
      result.halo_start.push_back(static_cast<int32_t>(result.halo.size()));
      result.halo.insert(result.halo.end(), group.halo.begin(), group.halo.end());
    }
  result.first_row.push_back(n);
  result.halo_start.push_back(static_cast<int32_t>(result.halo.size()));
  return result;
}

}  // namespace burnish::cuda
