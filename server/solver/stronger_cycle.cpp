#include "server/solver/stronger_cycle.h"

#include <algorithm>
#include <iterator>

#include "server/solver/slow_spots.h"

namespace burnish {

namespace {

// Shares of irregular rows at the depth above the finest.
constexpr double kSomeSheets = 1.0 / 40;
constexpr double kManySheets = 1.0 / 24;
constexpr int32_t kSmallScanCorners = 150'000;  // whose trial takes half a second
constexpr int kDepthsCorrectedTwice = 2;        // further up it gains nothing more
constexpr int kTrialsMax = 3;
constexpr size_t kFewSpots = 16;  // after so few the next trial would find hardly any
constexpr int32_t kTrialCornersMax = 4'000'000;  // a trial needs the memory of a session on the CPU

double share_of_irregular_rows(const HierarchyDepth& depth) {
  return static_cast<double>(depth.stencil.irregular.count()) / depth.grid.corner_count();
}

// With patches where one trial was slow, the next one shows what else is.
Status add_patches(const PreparedMesh& prepared, const std::shared_ptr<Hierarchy>& hierarchy,
                   const Progress& progress) {
  HierarchyDepth& finest = hierarchy->depths.back();
  if (finest.grid.corner_count() > kTrialCornersMax) return Status::ok();
  const std::shared_ptr<const PreparedMesh> not_owned(std::shared_ptr<void>(), &prepared);
  for (int trial = 0; trial < kTrialsMax; ++trial) {
    ASSIGN_OR_RETURN(std::vector<std::vector<int32_t>> spots,
                     find_slow_spots(not_owned, hierarchy, progress));
    if (spots.empty()) break;
    std::vector<std::vector<int32_t>> sets = finest.patches.corner_sets();
    std::ranges::move(spots, std::back_inserter(sets));
    finest.patches = make_patches(finest.grid, sets);
    if (spots.size() < kFewSpots) break;
  }
  return Status::ok();
}

}  // namespace

Status strengthen_cycle(const PreparedMesh& prepared, const std::shared_ptr<Hierarchy>& hierarchy,
                        const Progress& progress) {
  const int last = hierarchy->finest - 1;
  if (last <= hierarchy->coarsest) return Status::ok();
  const bool is_small = hierarchy->depths.back().grid.corner_count() < kSmallScanCorners;
  const double least = is_small ? kSomeSheets : kManySheets;
  if (share_of_irregular_rows(hierarchy->at(last)) <= least) return Status::ok();
  const int first = std::max(last - kDepthsCorrectedTwice, hierarchy->coarsest) + 1;
  for (int depth = first; depth <= hierarchy->finest; ++depth) {
    HierarchyDepth& one = hierarchy->depths[depth - hierarchy->coarsest];
    one.is_corrected_twice = depth <= last;
    one.has_weak_parts = true;
  }
  return add_patches(prepared, hierarchy, progress);
}

}  // namespace burnish
