#include "server/prepare/prepare.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>
#include <sstream>
#include <utility>

#include "common/base/heard_loop.h"
#include "common/base/limits.h"
#include "common/base/parallel.h"
#include "common/base/process_memory.h"
#include "common/base/text.h"
#include "common/evaluation/heard_evaluation.h"
#include "common/grid/depth_plan.h"
#include "common/mesh/stored_mesh.h"
#include "server/prepare/admission.h"
#include "server/prepare/cell_pieces.h"
#include "server/prepare/cell_sheets.h"
#include "server/prepare/histogram.h"
#include "server/prepare/integrate_cells.h"
#include "server/prepare/surface.h"
#include "server/prepare/thin_walls.h"

namespace burnish {

namespace {

/// Times the phases of a preparation.
class PhaseClock {
 public:
  /// `report` may be null.
  explicit PhaseClock(PrepareReport* report) : report_(report) { reset_peak_resident_bytes(); }

  /// Ends a phase; the next one begins.
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

/// The arrays behind the spans of a freshly prepared mesh.
struct PreparedArrays {
  std::shared_ptr<const void> mesh;
  ScratchArray<EvaluationPoint> evaluation;
  CellArrays cells;
  CellSheets sheets;
};

Status check_options(const PrepareOptions& options) {
  if (options.depth != 0 && (options.depth < kDepthMin || options.depth > kDepthMax))
    return invalid_argument("depth " + std::to_string(options.depth) + " is outside " +
                            std::to_string(kDepthMin) + ".." + std::to_string(kDepthMax));
  if (!(options.curvature_radius >= 0 && options.curvature_radius <= kCurvatureRadiusMax))
    return invalid_argument("curvature radius " + shortest_text(options.curvature_radius) +
                            " is outside 0.." + shortest_text(kCurvatureRadiusMax) +
                            " (a fraction of L, the square root of the area)");
  return Status::ok();
}

// Either the triangles are at fault, or a vertex is so far away that the rest is a point of the
// grid.
Status check_surface_is_left(const CellArrays& arrays, size_t triangles, const GridFrame& frame) {
  if (!arrays.cells.empty()) return Status::ok();
  std::ostringstream message;
  message << "the grid of depth " << frame.depth << " with cells of " << frame.cell_size
          << " holds no surface: all " << triangles
          << " triangles are too thin (area below 1e-12 of the longest edge squared) or too small "
             "(1e-7 of a cell)";
  return invalid_argument(message.str());
}

void point_at(PreparedMesh& prepared, const MeshView& mesh,
              std::shared_ptr<PreparedArrays> arrays) {
  prepared.vertices = mesh.vertices;
  prepared.triangles = mesh.triangles;
  prepared.colours = mesh.colours;
  prepared.evaluation = arrays->evaluation;
  prepared.cells = arrays->cells.cells;
  prepared.integrals = arrays->cells.integrals;
  prepared.curvature = arrays->cells.curvature;
  prepared.passages = arrays->cells.passages;
  prepared.sheets = arrays->sheets.sheets;
  prepared.sheet_integrals = arrays->sheets.integrals;
  prepared.storage = std::move(arrays);
}

/// The passes of one preparation, in their order.
class Preparation {
 public:
  Preparation(const ScanToPrepare& scan, Admission& admission, const Progress& progress,
              PhaseClock& clock)
      : scan_(scan),
        admission_(admission),
        progress_(progress),
        clock_(clock),
        frame_(scan.frame(admission.counts.depth)),
        length_unit_(std::sqrt(scan.statistics.area)) {}

  Status run() {
    positions_ = snapped_positions(scan_.mesh, frame_, space(), progress_);
    RETURN_IF_ERROR(cut());
    clock_.end("grid");
    RETURN_IF_ERROR(integrate());
    pieces_ = {};
    positions_ = {};
    arrays_->evaluation = ScratchArray<EvaluationPoint>(space(), scan_.mesh.vertices.size());
    make_evaluation(scan_.mesh, frame_, arrays_->cells.cells,
                    {arrays_->evaluation.data(), arrays_->evaluation.size()},
                    {progress_, "evaluation", 0, 0.9});
    return Status::ok();
  }

  std::shared_ptr<PreparedMesh> take(std::shared_ptr<const void> owner) {
    auto prepared = std::make_shared<PreparedMesh>();
    prepared->statistics = scan_.statistics;
    prepared->frame = frame_;
    prepared->length_unit = length_unit_;
    prepared->curvature_radius = scan_.options.curvature_radius;
    prepared->has_double_positions = scan_.mesh.has_double_positions;
    prepared->histogram =
        make_histogram(arrays_->cells.curvature, space(), {progress_, "evaluation", 0.9, 1});
    prepared->walls = walls_;
    arrays_->mesh = std::move(owner);
    point_at(*prepared, scan_.mesh, std::move(arrays_));
    clock_.end("evaluation");
    return prepared;
  }

 private:
  const ScratchSpace& space() const { return scan_.space(); }
  GridMesh grid_mesh() const { return {scan_.surface().triangles, positions_, frame_.depth}; }

  Status cut() {
    ASSIGN_OR_RETURN(const PieceCount count, admission_.count_pieces(grid_mesh(), progress_));
    if (!report(progress_, "grid", kCountedPart))
      return cancelled("cancelled while cutting at the grid");
    ASSIGN_OR_RETURN(pieces_, find_cell_pieces(grid_mesh(), count, scan_.room(), progress_));
    admission_.counts.cells = count_cells(pieces_);
    return admission_.ask();
  }

  Status integrate() {
    const MeshCurvature curvature(scan_.surface(), scan_.statistics,
                                  scan_.options.curvature_radius * length_unit_, space(),
                                  {progress_, "curvature"});
    clock_.end("curvature");
    const GridMesh mesh = grid_mesh();
    const Surface surface = {mesh, curvature, length_unit_};
    ASSIGN_OR_RETURN(arrays_->cells, integrate_cells(surface, pieces_, admission_.counts.cells,
                                                     space(), progress_));
    RETURN_IF_ERROR(check_surface_is_left(arrays_->cells, scan_.mesh.triangles.size(), frame_));
    if (scan_.statistics.components > 1) {
      const auto admit = [&](size_t sheets) {
        admission_.counts.sheets = sheets;
        return admission_.ask();
      };
      const CellArrays& cells = arrays_->cells;
      ASSIGN_OR_RETURN(arrays_->sheets,
                       find_cell_sheets(surface, pieces_, cells.cells, cells.passages, space(),
                                        admit, {progress_, "integrals", 0.9, 0.95}));
    }
    find_walls(surface);
    clock_.end("integrals");
    return Status::ok();
  }

  // The volume of an open surface is that between it and its middle: it tells which side is out.
  void find_walls(const Surface& surface) {
    const MeshStatistics& statistics = scan_.statistics;
    const double area = statistics.area / (frame_.cell_size * frame_.cell_size);
    walls_ = find_thin_walls(surface, pieces_, area, statistics.signed_volume < 0,
                             {progress_, "integrals", 0.95, 1});
  }

  const ScanToPrepare& scan_;
  Admission& admission_;
  const Progress& progress_;
  PhaseClock& clock_;
  const GridFrame frame_;
  const double length_unit_;
  ScratchArray<Vec3d> positions_;
  ScratchArray<CellPiece> pieces_;
  ThinWalls walls_;
  std::shared_ptr<PreparedArrays> arrays_ = std::make_shared<PreparedArrays>();
};

Result<std::shared_ptr<const PreparedMesh>> prepare_as_admitted(
    Admission& admission, const ScanToPrepare& scan, const Progress& progress, PhaseClock& clock,
    const std::shared_ptr<const void>& owner) {
  Preparation preparation(scan, admission, progress, clock);
  RETURN_IF_ERROR(preparation.run());
  auto prepared = preparation.take(owner);
  if (!report(progress, "evaluation", 1)) return cancelled("cancelled at the end");
  return std::shared_ptr<const PreparedMesh>(std::move(prepared));
}

Result<std::shared_ptr<const PreparedMesh>> prepare_scan(
    const MeshView& mesh, const std::shared_ptr<const void>& owner, const PrepareOptions& options,
    const Progress& progress, PreparationBudget& budget, PhaseClock& clock) {
  const PreparationNeed least =
      predict_preparation(counts_of(mesh, options), options.space.memory_bytes_max());
  RETURN_IF_ERROR(budget.ask(least).with_context(to_string(least)));

  const ScanToPrepare scan(mesh, options, progress);
  clock.end("statistics");
  const bool is_depth_given = options.depth != 0;
  int depth = is_depth_given ? options.depth
                             : default_depth(scan.statistics, budget.default_depth_bytes_max());
  // Cells are counted while they are prepared, so the first default may be too deep.
  for (;; --depth) {
    Admission admission{budget, scan.space().memory_bytes_max(), scan.counts(depth)};
    auto prepared = prepare_as_admitted(admission, scan, progress, clock, owner);
    if (prepared.status().code() != StatusCode::kResourceExhausted) return prepared;
    if (is_depth_given || depth == kDepthMin)
      return refusal(scan, admission, prepared.status(), progress);
  }
}

}  // namespace

// Asks the machine's memory if there is no other budget. Tells allocations that fail, and cancels.
template <typename Work>
static auto within_room(const MeshView& mesh, const PrepareOptions& options, PrepareReport* phases,
                        const Work& work) -> Result<std::shared_ptr<const PreparedMesh>> {
  RETURN_IF_ERROR(check_options(options));
  use_threads(options.threads);
  PhaseClock clock(phases);
  MachineBudget machine;
  PreparationBudget& budget = options.budget != nullptr ? *options.budget : machine;
  const auto scan = [&] {
    return "preparing a scan of " + std::to_string(mesh.triangles.size()) + " triangles: ";
  };
  try {
    return work(budget, clock);
  } catch (const WorkCancelled&) {
    return cancelled("preparing was cancelled");
  } catch (const ScratchFull& full) {
    return resource_exhausted(scan() + full.what());
  } catch (const std::bad_alloc&) {
    return resource_exhausted(scan() + "not enough memory; choose a smaller depth");
  }
}

Result<std::shared_ptr<const PreparedMesh>> prepare(const MeshView& mesh,
                                                    std::shared_ptr<const void> owner,
                                                    const PrepareOptions& options,
                                                    const Progress& progress,
                                                    PrepareReport* phases) {
  return within_room(mesh, options, phases, [&](PreparationBudget& budget, PhaseClock& clock) {
    return prepare_scan(mesh, owner, options, progress, budget, clock);
  });
}

Result<std::shared_ptr<const PreparedMesh>> prepare(const TriangleMesh& mesh,
                                                    const PrepareOptions& options,
                                                    const Progress& progress,
                                                    PrepareReport* phases) {
  return within_room(mesh, options, phases, [&](PreparationBudget& budget, PhaseClock& clock) {
    PrepareOptions with_copy = options;
    with_copy.copies_mesh = true;
    const auto copy = std::make_shared<const StoredMesh>(mesh, options.space);
    return prepare_scan(copy->view(), copy, with_copy, progress, budget, clock);
  });
}

}  // namespace burnish
