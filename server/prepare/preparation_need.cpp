#include "server/prepare/preparation_need.h"

#include <algorithm>

#include "common/base/process_memory.h"
#include "common/grid/depth_plan.h"
#include "common/mesh/triangle_mesh.h"
#include "server/prepare/cell_pieces.h"
#include "server/prepare/prepared_file.h"
#include "server/prepare/tangent_tensor.h"

namespace burnish {

namespace {

constexpr uint64_t kBytesInAnyCase = 8 << 20;  // threads' buffers, digits, counts by bucket
constexpr uint64_t kPiecesAtOnce = 1 << 17;    // of a batch of cells
constexpr uint64_t kBatchBytesPerPiece = 112;  // order, places, curvature
constexpr uint64_t kMixedCellBytes = 64;       // lists of cells with several components
constexpr uint64_t kCellBytes =
    sizeof(MortonKey) + sizeof(CellIntegrals) + sizeof(CellCurvature) + sizeof(Passages);
constexpr uint64_t kSheetBytes = sizeof(CellSheet) + sizeof(CellIntegrals);

uint64_t scan_bytes(const PreparationCounts& n) {
  return n.vertices * (sizeof(Vec3d) + (n.has_colours ? sizeof(Rgba8) : 0)) +
         n.triangles * sizeof(Triangle);
}

// For collect_edges() and count_vertices().
uint64_t statistics_bytes(const PreparationCounts& n) {
  return n.vertices * 8 + n.triangles * 13;
}

// For MeshCurvature: triangles around vertices, tensors of both, normals, areas.
uint64_t curvature_bytes(const PreparationCounts& n) {
  return n.vertices * (8 + sizeof(Vec3d) + sizeof(TangentTensor) + sizeof(double)) +
         n.triangles * (12 + sizeof(TangentTensor));
}

uint64_t kept_curvature_bytes(const PreparationCounts& n) {
  return n.vertices * (sizeof(Vec3d) + sizeof(TangentTensor));
}

// For integrate_cells() and find_cell_sheets(): marks, a copy of passages; components.
uint64_t integration_bytes(const PreparationCounts& n) {
  const uint64_t components = n.has_several_components ? n.vertices * sizeof(int32_t) : 0;
  return std::max(n.cells * (1 + sizeof(uint32_t)), components);
}

uint64_t evaluation_bytes(const PreparationCounts& n) {
  return n.vertices * sizeof(EvaluationPoint) + n.cells * 4 * sizeof(float);
}

// Counts all arrays in scratch space. The joined triangles stay to the end.
uint64_t arrays_bytes(const PreparationCounts& n) {
  const uint64_t scan = scan_bytes(n) + (n.has_joins ? n.triangles * sizeof(Triangle) : 0);
  const uint64_t pieces = scan + n.vertices * sizeof(Vec3d) + n.pieces * sizeof(CellPiece);
  const uint64_t of_cells = n.cells * kCellBytes + n.sheets * kSheetBytes;
  const uint64_t brick = std::min(n.pieces, PieceRoom::kPiecesPerBrick) * sizeof(CellPiece);
  return std::max({scan + statistics_bytes(n), pieces + brick, pieces + curvature_bytes(n),
                   pieces + kept_curvature_bytes(n) + of_cells + integration_bytes(n),
                   scan + of_cells + evaluation_bytes(n)});
}

// Counts everything else.
uint64_t heap_bytes(const PreparationCounts& n) {
  return kBytesInAnyCase + std::min(n.pieces, kPiecesAtOnce) * kBatchBytesPerPiece +
         n.vertices / 8 + (n.has_several_components ? n.cells * kMixedCellBytes : 0) +
         (n.copies_mesh ? scan_bytes(n) : 0);
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

PreparationNeed predict_preparation(const PreparationCounts& counts, uint64_t arrays_bytes_max) {
  const uint64_t arrays = arrays_bytes(counts);
  const uint64_t in_memory = std::min(arrays, arrays_bytes_max);
  return {counts, in_memory + heap_bytes(counts), arrays - in_memory, file_bytes(counts)};
}

std::string to_string(const PreparationNeed& need) {
  const PreparationCounts& counts = need.counts;
  const bool is_all = counts.cells > 0;
  std::string text = "preparing " + std::to_string(counts.triangles) + " triangles";
  if (counts.depth > 0) text += " at depth " + std::to_string(counts.depth);
  text += (is_all ? " takes " : " takes more than ") + mebibytes(need.memory_bytes) + " of memory";
  if (is_all)
    text +=
        need.scratch_bytes > 0 ? ", " + mebibytes(need.scratch_bytes) + " of scratch files" : "";
  if (is_all)
    text += " and a file of " + mebibytes(need.file_bytes) + " (" + std::to_string(counts.cells) +
            " cells)";
  return text;
}

MachineBudget::MachineBudget()
    : bytes_max_(std::min(available_memory_bytes(), machine_memory_bytes())) {}

uint64_t MachineBudget::default_depth_bytes_max() const {
  return memory_of_default_depth(machine_memory_bytes());
}

Status MachineBudget::ask(const PreparationNeed& need) {
  if (need.memory_bytes <= bytes_max_) return Status::ok();
  return resource_exhausted("the machine has " + mebibytes(bytes_max_) + " available");
}

}  // namespace burnish
