#include "server/prepare/preparation_need.h"

#include <algorithm>

#include "common/base/process_memory.h"
#include "common/grid/sparse_grid.h"
#include "common/mesh/triangle_mesh.h"
#include "server/prepare/cell_pieces.h"
#include "server/prepare/curvature.h"
#include "server/prepare/prepared_file.h"
#include "server/prepare/tangent_tensor.h"

namespace burnish {

namespace {

constexpr uint64_t kBytesInAnyCase = 4 << 20;  // threads' buffers, digits of the sort
constexpr uint64_t kHeapLostDivisor = 16;      // lost by the heap between blocks
constexpr uint64_t kCellBytes =
    sizeof(MortonKey) + sizeof(CellIntegrals) + sizeof(CellCurvature) + sizeof(Passages);
constexpr uint64_t kSheetBytes = sizeof(CellSheet) + sizeof(CellIntegrals);

uint64_t scan_bytes(const PreparationCounts& n) {
  return n.vertices * (sizeof(Vec3d) + (n.has_colours ? sizeof(Rgba8) : 0)) +
         n.triangles * sizeof(Triangle);
}

// For collect_edges() and count_vertices().
uint64_t statistics_bytes(const PreparationCounts& n) {
  return n.vertices * 13 + n.triangles * 12;
}

// For compute_curvature() with averaging: triangles around vertices, their tensors, normals, areas,
// the order of the buckets.
uint64_t curvature_bytes(const PreparationCounts& n) {
  return n.vertices * (8 + 24 + 2 * sizeof(TangentTensor) + 8 + 48) +
         n.triangles * (12 + sizeof(TangentTensor));
}

// For integrate_cells() and find_cell_sheets(): starts, marks, mixed cells with their components.
uint64_t integration_bytes(const PreparationCounts& n) {
  const uint64_t of_sheets =
      n.has_several_components ? n.vertices * 8 + n.cells * 128 + n.pieces * 8 + n.sheets * 16 : 0;
  return n.cells * 13 + of_sheets;
}

uint64_t evaluation_bytes(const PreparationCounts& n) {
  return n.vertices * (sizeof(EvaluationPoint) + 1) + n.cells * sizeof(GridKey);
}

uint64_t peak_bytes(const PreparationCounts& n) {
  const uint64_t positions = 2 * scan_bytes(n) + n.vertices * sizeof(Vec3d);
  const uint64_t pieces = positions + n.pieces * sizeof(CellPiece);
  const uint64_t curvature = pieces + n.triangles * sizeof(TriangleCurvature);
  const uint64_t cells = curvature + n.cells * kCellBytes + n.sheets * kSheetBytes;
  return std::max({scan_bytes(n) + statistics_bytes(n),
                   pieces + n.pieces * sizeof(CellPiece),  // the sort needs a second array
                   curvature + curvature_bytes(n), cells + integration_bytes(n),
                   cells + evaluation_bytes(n)});
}

uint64_t file_bytes(const PreparationCounts& n) {
  if (n.cells == 0) return 0;
  return sizeof(PreparedHeader) + kPreparedSections * kSectionAlignment + scan_bytes(n) +
         n.vertices * sizeof(EvaluationPoint) + n.cells * kCellBytes + n.sheets * kSheetBytes;
}

std::string mebibytes(uint64_t bytes) {
  return std::to_string((bytes + (1 << 20) - 1) >> 20) + " MiB";
}

}  // namespace

PreparationNeed predict_preparation(const PreparationCounts& counts) {
  const uint64_t peak = peak_bytes(counts);
  return {counts, peak + peak / kHeapLostDivisor + kBytesInAnyCase, file_bytes(counts)};
}

std::string to_string(const PreparationNeed& need) {
  const PreparationCounts& counts = need.counts;
  const bool is_all = counts.cells > 0;
  std::string text = "preparing " + std::to_string(counts.triangles) + " triangles";
  if (counts.depth > 0) text += " at depth " + std::to_string(counts.depth);
  text += (is_all ? " takes " : " takes more than ") + mebibytes(need.memory_bytes) + " of memory";
  if (is_all)
    text += " and a file of " + mebibytes(need.file_bytes) + " (" + std::to_string(counts.cells) +
            " cells)";
  return text;
}

MachineBudget::MachineBudget()
    : bytes_max_(std::min(available_memory_bytes(), machine_memory_bytes())) {}

Status MachineBudget::ask(const PreparationNeed& need) {
  if (need.memory_bytes <= bytes_max_) return Status::ok();
  return resource_exhausted("the machine has " + mebibytes(bytes_max_) + " available");
}

}  // namespace burnish
