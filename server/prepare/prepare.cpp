#include "server/prepare/prepare.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>
#include <sstream>
#include <utility>

#include "common/base/limits.h"
#include "common/base/parallel.h"
#include "common/base/process_memory.h"
#include "common/grid/sparse_grid.h"
#include "server/prepare/cell_integrals.h"
#include "server/prepare/cell_pieces.h"
#include "server/prepare/cell_sheets.h"
#include "server/prepare/curvature.h"
#include "server/prepare/histogram.h"
#include "server/prepare/surface.h"
#include "server/prepare/unset_vector.h"

namespace burnish {

namespace {

constexpr size_t kCellsPerBatch = 1 << 15;  // between two checks for a cancel

/// The arrays behind the spans of a freshly prepared mesh.
struct PreparedArrays {
  std::vector<Vec3d> vertices;
  std::vector<Triangle> triangles;
  std::vector<Rgba8> colours;
  std::vector<EvaluationPoint> evaluation;
  UnsetVector<MortonKey> cells;
  UnsetVector<CellIntegrals> integrals;
  UnsetVector<CellCurvature> curvature;
  UnsetVector<Passages> passages;
  CellSheets sheets;
};

/// Times the phases of a preparation.
class PhaseClock {
 public:
  explicit PhaseClock(PrepareReport* report) : report_(report) { reset_peak_resident_bytes(); }

  void end(const std::string& name) {
    const auto now = std::chrono::steady_clock::now();
    if (report_ != nullptr)
      report_->phases.push_back(
          {name, std::chrono::duration<double>(now - start_).count(), peak_resident_bytes()});
    start_ = now;
    reset_peak_resident_bytes();
  }

 private:
  PrepareReport* report_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

Status check_options(const PrepareOptions& options) {
  if (options.depth != 0 && (options.depth < kDepthMin || options.depth > kDepthMax))
    return invalid_argument("depth " + std::to_string(options.depth) + " is outside " +
                            std::to_string(kDepthMin) + ".." + std::to_string(kDepthMax));
  if (!(options.curvature_radius >= 0 && options.curvature_radius <= kCurvatureRadiusMax))
    return invalid_argument("curvature radius " + std::to_string(options.curvature_radius) +
                            " is outside 0.." + std::to_string(kCurvatureRadiusMax) +
                            " (a fraction of L, the square root of the area)");
  return Status::ok();
}

std::vector<Vec3d> snapped_positions(const TriangleMesh& mesh, const GridFrame& frame) {
  std::vector<Vec3d> positions(mesh.vertices.size());
#pragma omp parallel for schedule(static)
  for (int64_t v = 0; v < static_cast<int64_t>(positions.size()); ++v)
    positions[v] = snap_to_planes(frame.to_grid(mesh.vertices[v]));
  return positions;
}

/// The counts of a preparation, and the budget that admits them.
struct Admission {
  PreparationBudget& budget;
  PreparationCounts counts;

  Status ask() const { return budget.ask(predict_preparation(counts)); }

  /// Returns how many pieces may be counted before they are sure to exceed the budget.
  uint64_t pieces_max() const {
    const uint64_t before = predict_preparation(counts).memory_bytes;
    const uint64_t limit = budget.memory_bytes_max();
    return limit < before ? 0 : (limit - before) / (2 * sizeof(CellPiece));  // the sort takes twice
  }

  Result<PieceCount> count_pieces(const TriangleMesh& mesh, std::span<const Vec3d> positions) {
    const uint64_t limit = pieces_max();
    auto count = count_cell_pieces(mesh.triangles, positions, limit);
    counts.pieces = count.is_ok() ? count->total() : limit + 1;
    if (count.is_ok()) RETURN_IF_ERROR(ask());
    return count;
  }
};

PreparationCounts counts_of(const TriangleMesh& mesh, int depth) {
  PreparationCounts counts;
  counts.depth = depth;
  counts.vertices = mesh.vertices.size();
  counts.triangles = mesh.triangles.size();
  counts.has_colours = !mesh.colours.empty();
  return counts;
}

/// The part of the scan that does not depend on the depth.
struct Scan {
  const TriangleMesh& mesh;
  MeshStatistics statistics;

  GridFrame frame(int depth) const {
    return make_grid_frame(statistics.box_min, statistics.box_max, depth);
  }
  PreparationCounts counts(int depth) const {
    PreparationCounts counts = counts_of(mesh, depth);
    counts.has_several_components = statistics.components > 1;
    return counts;
  }
};

// Counts cells only: a preparation finds sheets later.
Status ask_for_depth(const Scan& scan, int depth, PreparationBudget& budget) {
  Admission admission{budget, scan.counts(depth)};
  const std::vector<Vec3d> positions = snapped_positions(scan.mesh, scan.frame(depth));
  ASSIGN_OR_RETURN(const PieceCount count, admission.count_pieces(scan.mesh, positions));
  admission.counts.cells = count_cells(scan.mesh.triangles, positions, count);
  return admission.ask();
}

// Says why nothing was prepared at this depth, and which depth would fit.
Status refusal(const Scan& scan, const PreparationCounts& counts, const Status& reason,
               PreparationBudget& budget, const Progress& progress) {
  int depth = counts.depth - 1;
  while (depth >= kDepthMin && !ask_for_depth(scan, depth, budget).is_ok()) {
    if (!report(progress, "looking for a depth that fits", 0))
      return cancelled("cancelled while looking for a depth that fits");
    --depth;
  }
  return resource_exhausted(
      to_string(predict_preparation(counts)) + ": " + reason.message() +
      (depth >= kDepthMin ? "; depth " + std::to_string(depth) + " fits" : "; no depth fits"));
}

/// Integrates over the pieces of one cell. Returns false if the cell has no area left.
bool integrate_cell(const Surface& surface, std::span<const CellPiece> pieces,
                    CellIntegrals& integrals, CellCurvature& curvature) {
  CellIntegrator integrator;
  double kappa1 = 0, kappa2 = 0;
  for (const CellPiece& piece : pieces) {
    const double area = surface.integrate(piece, integrator);
    kappa1 += area * surface.curvature[piece.triangle].kappa1;
    kappa2 += area * surface.curvature[piece.triangle].kappa2;
  }
  if (integrator.area() <= 0) return false;
  const double scale = surface.length_unit / integrator.area();
  integrals = integrator.integrals();
  curvature = {static_cast<float>(kappa1 * scale), static_cast<float>(kappa2 * scale),
               static_cast<float>(integrator.area())};
  return true;
}

Passages passages_of(std::span<const CellPiece> pieces) {
  Passages all = 0;
  for (const CellPiece& piece : pieces) all |= piece.passages;
  return all;
}

/// Keeps the cells that hold surface, in order.
void keep(PreparedArrays& arrays, const std::vector<char>& holds_surface) {
  if (std::ranges::find(holds_surface, 0) == holds_surface.end()) return;
  for (size_t c = 0; c < holds_surface.size(); ++c)
    if (!holds_surface[c]) doubt_passages_to(c, arrays.cells, arrays.passages);
  size_t kept = 0;
  for (size_t c = 0; c < holds_surface.size(); ++c) {
    if (!holds_surface[c]) continue;
    arrays.cells[kept] = arrays.cells[c];
    arrays.integrals[kept] = arrays.integrals[c];
    arrays.curvature[kept] = arrays.curvature[c];
    arrays.passages[kept] = arrays.passages[c];
    ++kept;
  }
  arrays.cells.resize(kept);
  arrays.integrals.resize(kept);
  arrays.curvature.resize(kept);
  arrays.passages.resize(kept);
}

Status integrate_cells(const Surface& surface, std::span<const CellPiece> pieces,
                       const Progress& progress, PreparedArrays& arrays) {
  const std::vector<size_t> starts = cell_starts(pieces);
  const size_t cell_count = starts.size() - 1;
  arrays.cells.resize(cell_count);
  arrays.integrals.resize(cell_count);
  arrays.curvature.resize(cell_count);
  arrays.passages.resize(cell_count);
  std::vector<char> holds_surface(cell_count);

  for (size_t batch = 0; batch < cell_count; batch += kCellsPerBatch) {
    const size_t end = std::min(cell_count, batch + kCellsPerBatch);
#pragma omp parallel for schedule(dynamic, 64)
    for (size_t c = batch; c < end; ++c) {
      const auto of_cell = pieces.subspan(starts[c], starts[c + 1] - starts[c]);
      arrays.cells[c] = of_cell.front().cell;
      arrays.passages[c] = passages_of(of_cell);
      holds_surface[c] = integrate_cell(surface, of_cell, arrays.integrals[c], arrays.curvature[c]);
    }
    if (!report(progress, "integrals", static_cast<double>(end) / cell_count))
      return cancelled("cancelled while integrating");
  }
  keep(arrays, holds_surface);
  close_one_sided_passages(arrays.cells, arrays.passages);
  return Status::ok();
}

// Either the triangles are at fault, or a vertex is so far away that the rest is a point of the
// grid.
Status check_surface_is_left(const PreparedArrays& arrays, const GridFrame& frame) {
  if (!arrays.cells.empty()) return Status::ok();
  std::ostringstream message;
  message << "the grid of depth " << frame.depth << " with cells of " << frame.cell_size
          << " holds no surface: all " << arrays.triangles.size()
          << " triangles are too thin (area below 1e-12 of the longest edge squared) or too small "
             "(1e-7 of a cell)";
  return invalid_argument(message.str());
}

void point_at(PreparedMesh& prepared, std::shared_ptr<PreparedArrays> arrays) {
  prepared.vertices = arrays->vertices;
  prepared.triangles = arrays->triangles;
  prepared.colours = arrays->colours;
  prepared.evaluation = arrays->evaluation;
  prepared.cells = arrays->cells;
  prepared.integrals = arrays->integrals;
  prepared.curvature = arrays->curvature;
  prepared.passages = arrays->passages;
  prepared.sheets = arrays->sheets.sheets;
  prepared.sheet_integrals = arrays->sheets.integrals;
  prepared.storage = std::move(arrays);
}

Result<std::shared_ptr<const PreparedMesh>> prepare_scan(const Scan& scan, Admission& admission,
                                                         const PrepareOptions& options,
                                                         const Progress& progress,
                                                         PhaseClock& clock) {
  const TriangleMesh& mesh = scan.mesh;
  auto prepared = std::make_shared<PreparedMesh>();
  prepared->statistics = scan.statistics;
  prepared->frame = scan.frame(admission.counts.depth);
  prepared->length_unit = std::sqrt(scan.statistics.area);
  prepared->curvature_radius = options.curvature_radius;
  prepared->has_double_positions = mesh.has_double_positions;
  if (!report(progress, "grid", 0)) return cancelled("cancelled before cutting at the grid");

  const std::vector<Vec3d> positions = snapped_positions(mesh, prepared->frame);
  ASSIGN_OR_RETURN(const PieceCount count, admission.count_pieces(mesh, positions));
  if (!report(progress, "grid", 0.4)) return cancelled("cancelled while cutting at the grid");
  ASSIGN_OR_RETURN(const UnsetVector<CellPiece> pieces,
                   find_cell_pieces(mesh.triangles, positions, count, progress));
  admission.counts.cells = count_cells(pieces);
  RETURN_IF_ERROR(admission.ask());
  clock.end("grid");
  if (!report(progress, "curvature", 0)) return cancelled("cancelled before the curvature");

  const UnsetVector<TriangleCurvature> curvature =
      compute_curvature(mesh, scan.statistics, options.curvature_radius * prepared->length_unit);
  clock.end("curvature");

  auto arrays = std::make_shared<PreparedArrays>();
  arrays->vertices = mesh.vertices;
  arrays->triangles = mesh.triangles;
  arrays->colours = mesh.colours;
  const Surface surface = {arrays->triangles, positions, curvature, prepared->length_unit};
  RETURN_IF_ERROR(integrate_cells(surface, pieces, progress, *arrays));
  RETURN_IF_ERROR(check_surface_is_left(*arrays, prepared->frame));
  if (scan.statistics.components > 1) {
    const auto admit = [&](size_t sheets) {
      admission.counts.sheets = sheets;
      return admission.ask();
    };
    ASSIGN_OR_RETURN(arrays->sheets,
                     find_cell_sheets(surface, pieces, arrays->cells, arrays->passages, admit));
  }
  clock.end("integrals");

  arrays->evaluation = make_evaluation(
      mesh, prepared->frame, SparseGrid{prepared->frame.depth, finest_keys(arrays->cells)});
  prepared->histogram = make_histogram(arrays->curvature);
  point_at(*prepared, std::move(arrays));
  clock.end("evaluation");
  if (!report(progress, "evaluation", 1)) return cancelled("cancelled at the end");
  return std::shared_ptr<const PreparedMesh>(std::move(prepared));
}

}  // namespace

Result<std::shared_ptr<const PreparedMesh>> prepare(const TriangleMesh& mesh,
                                                    const PrepareOptions& options,
                                                    const Progress& progress,
                                                    PrepareReport* phases) try {
  RETURN_IF_ERROR(check_options(options));
  use_threads(options.threads);
  PhaseClock clock(phases);
  MachineBudget machine;
  PreparationBudget& budget = options.budget != nullptr ? *options.budget : machine;
  const PreparationNeed least = predict_preparation(counts_of(mesh, options.depth));
  RETURN_IF_ERROR(budget.ask(least).with_context(to_string(least)));

  const Scan scan = {mesh, compute_statistics(mesh)};
  const MeshStatistics& statistics = scan.statistics;
  const int depth = options.depth != 0 ? options.depth
                                       : default_depth(statistics.box_min, statistics.box_max,
                                                       statistics.mean_edge_length);
  clock.end("statistics");
  Admission admission{budget, scan.counts(depth)};
  auto prepared = prepare_scan(scan, admission, options, progress, clock);
  if (prepared.status().code() != StatusCode::kResourceExhausted) return prepared;
  return refusal(scan, admission.counts, prepared.status(), budget, progress);
} catch (const std::bad_alloc&) {
  return resource_exhausted("preparing a scan of " + std::to_string(mesh.triangles.size()) +
                            " triangles: not enough memory; choose a smaller depth");
}

}  // namespace burnish
