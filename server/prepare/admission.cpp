#include "server/prepare/admission.h"

#include <string>

#include "common/base/limits.h"

namespace burnish {

PreparationCounts counts_of(const MeshView& mesh, const PrepareOptions& options) {
  PreparationCounts counts;
  counts.copies_mesh = options.copies_mesh;
  counts.depth = options.depth;
  counts.vertices = mesh.vertices.size();
  counts.triangles = mesh.triangles.size();
  counts.has_colours = !mesh.colours.empty();
  return counts;
}

PreparationCounts ScanToPrepare::counts(int depth) const {
  PreparationCounts counts = counts_of(mesh, options);
  counts.depth = depth;
  counts.has_several_components = statistics.components > 1;
  counts.has_joins = joined.has_joins();
  return counts;
}

uint64_t Admission::pieces_max() const {
  const PreparationNeed before = need();
  const uint64_t taken = before.memory_bytes + before.scratch_bytes;
  const uint64_t limit = budget.memory_bytes_max() + budget.scratch_bytes_max();
  return limit < taken ? 0 : (limit - taken) / sizeof(CellPiece);
}

Result<PieceCount> Admission::count_pieces(const GridMesh& mesh, const Progress& progress) {
  const uint64_t limit = pieces_max();
  auto count = count_cell_pieces(mesh, limit, progress);
  if (count.status().code() == StatusCode::kCancelled) return count;
  counts.pieces = count.is_ok() ? count->total() : limit + 1;
  if (count.is_ok()) RETURN_IF_ERROR(ask());
  return count;
}

ScratchArray<Vec3d> snapped_positions(const MeshView& mesh, const GridFrame& frame,
                                      const ScratchSpace& space, const Progress& progress) {
  ScratchArray<Vec3d> positions(space, mesh.vertices.size());
  parallel_for_heard({progress, "grid", 0, 0}, positions.size(), [&](size_t v) {
    positions[v] = snap_to_planes(frame.to_grid(mesh.vertices[v]));
  });
  return positions;
}

// Counts cells only: a preparation finds sheets later.
static Status ask_for_depth(const ScanToPrepare& scan, int depth, PreparationBudget& budget,
                            const Progress& progress) {
  Admission admission{budget, scan.space().memory_bytes_max(), scan.counts(depth)};
  const auto positions = snapped_positions(scan.mesh, scan.frame(depth), scan.space(), progress);
  const GridMesh mesh = {scan.surface().triangles, positions, depth};
  ASSIGN_OR_RETURN(const PieceCount count, admission.count_pieces(mesh, progress));
  ASSIGN_OR_RETURN(const auto pieces, find_cell_pieces(mesh, count, scan.room(), progress));
  admission.counts.cells = count_cells(pieces);
  return admission.ask();
}

Status refusal(const ScanToPrepare& scan, const Admission& admission, const Status& reason,
               const Progress& progress) {
  PreparationBudget& budget = admission.budget;
  int depth = admission.counts.depth - 1;
  while (depth >= kDepthMin && !ask_for_depth(scan, depth, budget, progress).is_ok()) {
    if (!report(progress, "looking for a depth that fits", 0))
      return cancelled("cancelled while looking for a depth that fits");
    --depth;
  }
  return resource_exhausted(
      to_string(admission.need()) + ": " + reason.message() +
      (depth >= kDepthMin ? "; depth " + std::to_string(depth) + " fits" : "; no depth fits"));
}

}  // namespace burnish
