#include "server/solver/tuning/slow_spots.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "common/base/sort_once.h"
#include "server/fields/fields.h"
#include "server/solver/hierarchy/corner_sets.h"
#include "server/solver/solver.h"

namespace burnish {

namespace {

/// Limits the distance of a vertex from the trial's end.
struct Milestone {
  int steps;
  double distance;  // of the diagonal
};
// A good trial stays well within these. They are a fifth and a tenth of the strictest bars of a
// cold start, after five and ten steps.
constexpr Milestone kMilestones[] = {{5, 2e-5}, {8, 1e-6}};
constexpr int kStepsOfTrial = 16;
// A small α moves the whole surface, and spots do not stand out.
constexpr double kAlpha = 50;
constexpr int kRingsMax = 4;
constexpr size_t kSpotsMax = 512;  // per trial; the worst spots hide others from it

using Corners = std::vector<int32_t>;

class Trial {
 public:
  explicit Trial(std::unique_ptr<Solver> solver) : solver_(std::move(solver)) {}

  Result<std::vector<Vec3f>> displacement_after(int steps, const Progress& progress) {
    for (; steps_ < steps; ++steps_) {
      if (!report(progress, "looking for slow spots", double(steps_) / kStepsOfTrial))
        return cancelled("cancelled while looking for slow spots");
      solver_->step();
    }
    const auto moved = solver_->vertex_displacement();
    return std::vector<Vec3f>(moved.begin(), moved.end());
  }

 private:
  std::unique_ptr<Solver> solver_;
  int steps_ = 0;
};

Trial start_trial(const Multigrid& on) {
  Fields fields(*on.prepared);
  fields.set_transfer_curve(TransferCurve(kAlpha));
  fields.set_gradient_scale(0);
  auto solver = Solver::create(on, {.backend = BackendKind::kCpu}).value();
  solver->set_metric(fields.view());
  return Trial(std::move(solver));
}

struct SlowCell {
  double late;  // distance of a vertex in it over the allowed one, at the worst milestone
  int32_t cell;
};

// Returns the cells of vertices that miss a milestone, the slowest first. A cell may occur more
// than once.
Result<std::vector<SlowCell>> find_slow_cells(const Multigrid& on, const Progress& progress) {
  Trial trial = start_trial(on);
  std::array<std::vector<Vec3f>, std::size(kMilestones)> passed;
  for (size_t i = 0; i < passed.size(); ++i) {
    ASSIGN_OR_RETURN(passed[i], trial.displacement_after(kMilestones[i].steps, progress));
  }
  ASSIGN_OR_RETURN(const std::vector<Vec3f> ends,
                   trial.displacement_after(kStepsOfTrial, progress));

  const double diagonal = on.prepared->statistics.diagonal() / on.prepared->frame.cell_size;
  std::vector<SlowCell> slow;
  for (size_t v = 0; v < ends.size(); ++v) {
    double late = 0;
    for (size_t i = 0; i < passed.size(); ++i)
      late = std::max(late, (ends[v] - passed[i][v]).norm() / (kMilestones[i].distance * diagonal));
    if (late > 1) slow.push_back({late, on.prepared->evaluation[v].cell});
  }
  std::ranges::stable_sort(slow, std::ranges::greater(), &SlowCell::late);
  return slow;
}

Corners corners_of(const SparseGrid& grid, int32_t cell) {
  Corners corners(grid.cell_corners[cell].begin(), grid.cell_corners[cell].end());
  std::ranges::sort(corners);
  return corners;
}

Corners spot_around(const SparseGrid& grid, int32_t cell) {
  Corners spot = corners_of(grid, cell);
  for (int ring = 0; ring < kRingsMax; ++ring) {
    std::vector<int32_t> cells;
    for_each_cell_around(grid, spot, [&](int32_t near) { cells.push_back(near); });
    sort_once(cells);
    Corners wider;
    for (const int32_t near : cells)
      wider.insert(wider.end(), grid.cell_corners[near].begin(), grid.cell_corners[near].end());
    sort_once(wider);
    if (wider.size() > kPatchCornersMax || wider.size() == spot.size()) break;
    spot = std::move(wider);
  }
  return spot;
}

}  // namespace

Result<std::vector<Corners>> find_slow_spots(const Multigrid& on, const Progress& progress) {
  ASSIGN_OR_RETURN(const std::vector<SlowCell> cells, find_slow_cells(on, progress));
  const SparseGrid& grid = on.hierarchy->depths.back().grid;
  std::vector<char> is_near(grid.cells.size());
  std::vector<Corners> spots;
  for (const SlowCell& slow : cells) {
    if (is_near[slow.cell]) continue;
    if (spots.size() == kSpotsMax) break;
    spots.push_back(spot_around(grid, slow.cell));
    for_each_cell_around(grid, corners_of(grid, slow.cell),
                         [&](int32_t cell) { is_near[cell] = true; });
  }
  return spots;
}

}  // namespace burnish
