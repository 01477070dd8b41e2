#pragma once

#include "common/mesh/joined_mesh.h"
#include "common/mesh/statistics/heard_statistics.h"
#include "server/prepare/cell_pieces.h"
#include "server/prepare/piece_count.h"
#include "server/prepare/preparation_need.h"
#include "server/prepare/prepare.h"

namespace burnish {

/// Returns the counts that are known before any work.
PreparationCounts counts_of(const MeshView& mesh, const PrepareOptions& options);

/// The part of the scan that does not depend on the depth.
struct ScanToPrepare {
  /// Throws: WorkCancelled.
  ScanToPrepare(const MeshView& mesh_of_scan, const PrepareOptions& options_of_scan,
                const Progress& progress)
      : mesh(mesh_of_scan),
        options(options_of_scan),
        joined(mesh, options.space, {progress, "statistics", 0, 0.4}),
        statistics(
            compute_statistics(mesh, surface(), options.space, {progress, "statistics", 0.4, 1})) {}

  const MeshView& mesh;
  const PrepareOptions& options;
  JoinedMesh joined;
  MeshStatistics statistics;

  /// The mesh by the places of its vertices: all that is known of the surface comes from it.
  const MeshView& surface() const { return joined.view(); }

  const ScratchSpace& space() const { return options.space; }
  PieceRoom room() const { return {options.space, options.pieces_per_brick}; }

  GridFrame frame(int depth) const {
    return make_grid_frame(statistics.box_min, statistics.box_max, depth);
  }
  PreparationCounts counts(int depth) const;
};

/// The counts of a preparation, and the budget that admits them.
struct Admission {
  PreparationBudget& budget;
  uint64_t arrays_bytes_max;
  PreparationCounts counts;

  PreparationNeed need() const { return predict_preparation(counts, arrays_bytes_max); }
  Status ask() const { return budget.ask(need()); }

  /// Returns how many pieces may be counted before they are sure to exceed the budget.
  uint64_t pieces_max() const;

  /// Counts the pieces, and asks the budget for them. Fails: resource_exhausted, cancelled.
  Result<PieceCount> count_pieces(const GridMesh& mesh, const Progress& progress);
};

/// Returns the positions in grid units. A vertex near a grid plane lies on it. Throws:
/// WorkCancelled.
ScratchArray<Vec3d> snapped_positions(const MeshView& mesh, const GridFrame& frame,
                                      const ScratchSpace& space, const Progress& progress);

/// Says why nothing was prepared at this depth, and which depth would fit.
Status refusal(const ScanToPrepare& scan, const Admission& admission, const Status& reason,
               const Progress& progress);

}  // namespace burnish
