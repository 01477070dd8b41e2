#include "server/solver/stronger_cycle.h"

#include <algorithm>
#include <iterator>

#include "server/solver/slow_spots.h"

namespace burnish {

namespace {

constexpr int32_t kRowsPerIrregularRow = 24;
constexpr int kDepthsCorrectedTwice = 2;  // further up it gains nothing more
constexpr int kTrialsMax = 3;
constexpr int32_t kTrialCornersMax = 4'000'000;  // a trial needs the memory of a session on the CPU

bool has_many_sheets(const HierarchyDepth& depth) {
  return depth.stencil.irregular.count() > depth.grid.corner_count() / kRowsPerIrregularRow;
}

// With patches where one trial was slow, the next one shows what else is.
void add_patches(const PreparedMesh& prepared, const std::shared_ptr<Hierarchy>& hierarchy) {
  HierarchyDepth& finest = hierarchy->depths.back();
  if (finest.grid.corner_count() > kTrialCornersMax) return;
  const std::shared_ptr<const PreparedMesh> not_owned(std::shared_ptr<void>(), &prepared);
  for (int trial = 0; trial < kTrialsMax; ++trial) {
    std::vector<std::vector<int32_t>> spots = find_slow_spots(not_owned, hierarchy);
    if (spots.empty()) return;
    std::vector<std::vector<int32_t>> sets = finest.patches.corner_sets();
    std::ranges::move(spots, std::back_inserter(sets));
    finest.patches = make_patches(finest.grid, sets);
  }
}

}  // namespace

void strengthen_cycle(const PreparedMesh& prepared, const std::shared_ptr<Hierarchy>& hierarchy) {
  const int last = hierarchy->finest - 1;
  if (last <= hierarchy->coarsest || !has_many_sheets(hierarchy->at(last))) return;
  const int first = std::max(last - kDepthsCorrectedTwice, hierarchy->coarsest) + 1;
  for (int depth = first; depth <= hierarchy->finest; ++depth) {
    HierarchyDepth& one = hierarchy->depths[depth - hierarchy->coarsest];
    one.is_corrected_twice = depth <= last;
    one.has_weak_parts = true;
  }
  add_patches(prepared, hierarchy);
}

}  // namespace burnish
