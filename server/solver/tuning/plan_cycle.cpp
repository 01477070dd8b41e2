#include "server/solver/tuning/plan_cycle.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "server/solver/tuning/slow_spots.h"

namespace burnish {

namespace {

// Parts of irregular rows at the depth above the finest.
constexpr double kSomeSheets = 1.0 / 40;
constexpr double kManySheets = 1.0 / 24;
constexpr int32_t kSmallScanCorners = 150'000;  // a trial on it takes half a second
constexpr int kDepthsCorrectedTwice = 2;        // more gains nothing
constexpr int kTrialsMax = 3;
constexpr size_t kFewSpots = 16;  // after so few spots the next trial would find hardly any
constexpr int32_t kTrialCornersMax = 4'000'000;  // a trial needs the memory of a session on the CPU

// Energy goes with the square of the bend: 1e-8 is still far above the 38 bits of S on CUDA.
constexpr double kFlatBend = 1e-4;
constexpr double kFlatShareMin = 1e-3;  // a lone cell is flat by chance

double share_of_irregular_rows(const HierarchyDepth& depth) {
  return static_cast<double>(depth.stencil.irregular.count()) / depth.grid.corner_count();
}

/// Returns whether some of the surface is flat: it bends by less than 1e-4 across a cell. A flat
/// piece has moves that take no energy in exact numbers; rounded numbers give them one, of either
/// sign. Scans are never flat because of their noise; designed parts and filled holes are.
bool has_flat_parts(const PreparedMesh& prepared) {
  double flat = 0, whole = 0;
  for (const CellCurvature& cell : prepared.curvature) {
    const double bend =
        std::max(std::abs(cell.kappa1), std::abs(cell.kappa2)) * prepared.alpha_scale();
    whole += cell.area;
    if (bend < kFlatBend) flat += cell.area;
  }
  return flat > kFlatShareMin * whole;
}

/// Returns the first depth with weak parts, or nothing if few sheets come together.
std::optional<int> first_weak_depth(const Hierarchy& hierarchy) {
  const int last = hierarchy.finest - 1;
  if (last <= hierarchy.coarsest) return std::nullopt;
  const bool is_small = hierarchy.depths.back().grid.corner_count() < kSmallScanCorners;
  if (share_of_irregular_rows(hierarchy.at(last)) <= (is_small ? kSomeSheets : kManySheets))
    return std::nullopt;
  return std::max(last - kDepthsCorrectedTwice, hierarchy.coarsest) + 1;
}

/// Runs further trials with the patches of the earlier ones: they show other slow spots.
Result<Patches> patches_on_slow_spots(const Multigrid& on, const Progress& progress) {
  const SparseGrid& finest = on.hierarchy->depths.back().grid;
  CyclePlan plan = *on.plan;
  for (int trial = 0; trial < kTrialsMax; ++trial) {
    const Multigrid tried{on.prepared, on.hierarchy, std::make_shared<CyclePlan>(plan)};
    ASSIGN_OR_RETURN(std::vector<std::vector<int32_t>> spots, find_slow_spots(tried, progress));
    if (spots.empty()) break;
    std::vector<std::vector<int32_t>> sets = plan.patches.corner_sets();
    std::ranges::move(spots, std::back_inserter(sets));
    plan.patches = make_patches(finest, sets);
    if (spots.size() < kFewSpots) break;
  }
  return plan.patches;
}

}  // namespace

bool needs_trials(const Hierarchy& hierarchy) {
  return first_weak_depth(hierarchy) &&
         hierarchy.depths.back().grid.corner_count() <= kTrialCornersMax;
}

Result<std::shared_ptr<const CyclePlan>> plan_cycle(
    const std::shared_ptr<const PreparedMesh>& prepared,
    const std::shared_ptr<const Hierarchy>& hierarchy, const Progress& progress) {
  const auto plan = std::make_shared<CyclePlan>();
  plan->patches = hierarchy->small_components;
  plan->has_flat_parts = has_flat_parts(*prepared);
  if (const auto weak = first_weak_depth(*hierarchy)) {
    plan->first_weak_depth = *weak;
    if (!needs_trials(*hierarchy)) return std::shared_ptr<const CyclePlan>(plan);
    ASSIGN_OR_RETURN(plan->patches, patches_on_slow_spots({prepared, hierarchy, plan}, progress));
  }
  return std::shared_ptr<const CyclePlan>(plan);
}

Result<Multigrid> make_multigrid(std::shared_ptr<const PreparedMesh> prepared,
                                 const Progress& progress) {
  Multigrid made{std::move(prepared), nullptr, nullptr};
  ASSIGN_OR_RETURN(made.hierarchy, make_hierarchy(*made.prepared, progress));
  ASSIGN_OR_RETURN(made.plan, plan_cycle(made.prepared, made.hierarchy, progress));
  return made;
}

}  // namespace burnish
