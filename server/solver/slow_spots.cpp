#include "server/solver/slow_spots.h"

#include <algorithm>

#include "server/solver/corner_sets.h"
#include "server/solver/fields.h"
#include "server/solver/hierarchy.h"
#include "server/solver/solver.h"

namespace burnish {

namespace {

// Where all is well the trial is within a few millionths of the diagonal by then.
constexpr int kStepsToSettle = 8;
constexpr int kStepsToMove = 8;
constexpr double kSlowMove = 1e-6;  // of the diagonal: a tenth of the strictest bar after ten steps
// At small ones the whole surface moves, and spots do not stand out.
constexpr double kAlpha = 50;
constexpr int kRingsMax = 4;
constexpr size_t kSpotsMax = 512;  // a trial: what the worst of them hide shows in the next

using Corners = std::vector<int32_t>;

std::vector<Vec3f> displacement_after(Solver& solver, int steps) {
  for (int i = 0; i < steps; ++i) solver.step();
  const auto moved = solver.vertex_displacement();
  return {moved.begin(), moved.end()};
}

struct SlowCell {
  float move;  // of a vertex in it, in cells
  int32_t cell;
};

// Cells of vertices that move, the slowest first. A cell may be there more than once.
std::vector<SlowCell> find_slow_cells(const std::shared_ptr<const PreparedMesh>& prepared,
                                      const std::shared_ptr<const Hierarchy>& hierarchy) {
  Fields fields(*prepared);
  fields.set_transfer_curve(TransferCurve(kAlpha));
  fields.set_gradient_scale(0);
  const auto solver = Solver::create(prepared, hierarchy, {.backend = BackendKind::kCpu}).value();
  solver->set_metric(fields.view());
  const std::vector<Vec3f> settled = displacement_after(*solver, kStepsToSettle);
  const std::vector<Vec3f> later = displacement_after(*solver, kStepsToMove);

  const double diagonal = prepared->statistics.diagonal() / prepared->frame.cell_size;
  const auto least = static_cast<float>(kSlowMove * diagonal);
  std::vector<SlowCell> slow;
  for (size_t v = 0; v < settled.size(); ++v) {
    const float move = (later[v] - settled[v]).norm();
    if (move > least) slow.push_back({move, prepared->evaluation[v].cell});
  }
  std::ranges::stable_sort(slow, std::ranges::greater(), &SlowCell::move);
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

std::vector<Corners> find_slow_spots(std::shared_ptr<const PreparedMesh> prepared,
                                     std::shared_ptr<const Hierarchy> hierarchy) {
  const SparseGrid& grid = hierarchy->at(hierarchy->finest).grid;
  std::vector<char> is_near(grid.cells.size());
  std::vector<Corners> spots;
  for (const SlowCell& slow : find_slow_cells(prepared, hierarchy)) {
    if (is_near[slow.cell]) continue;
    if (spots.size() == kSpotsMax) break;
    spots.push_back(spot_around(grid, slow.cell));
    for_each_cell_around(grid, corners_of(grid, slow.cell),
                         [&](int32_t cell) { is_near[cell] = true; });
  }
  return spots;
}

}  // namespace burnish
