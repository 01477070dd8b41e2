#include "server/memory/opening_need.h"

#include "server/fields/rims.h"

namespace burnish {

// Measured on real scans and rounded up. A cell of the finest depth brings about two corners, and
// the coarser depths a third of that again (docs/benchmarks.md has the figures).
static constexpr uint64_t kHierarchyBytesPerCell = 704;
static constexpr uint64_t kHierarchyBytesPerVertex = 12;  // PointsByCell
// For the fewest possible corners: a session on processors, one on devices, its part there.
static constexpr uint64_t kSessionBytesPerCellMin = 900;
static constexpr uint64_t kHostBytesPerCellMin = 120;
static constexpr uint64_t kDeviceBytesPerCellMin = 1600;

static constexpr uint64_t kFileBytesMin = uint64_t{16} << 20;  // less is not worth a file

PreparedPlace place_of_prepared(uint64_t bytes) {
  return bytes < kFileBytesMin ? PreparedPlace::kMemory : PreparedPlace::kFile;
}

static uint64_t mesh_bytes(uint64_t byte_count, PreparedPlace place, uint64_t cells,
                           uint64_t vertices) {
  return (place == PreparedPlace::kMemory ? byte_count : 0) + cells * kHierarchyBytesPerCell +
         vertices * kHierarchyBytesPerVertex;
}

uint64_t predict_mesh_bytes(const PreparedMesh& prepared, PreparedPlace place) {
  return mesh_bytes(prepared.byte_count(), place, prepared.cells.size(), prepared.vertices.size());
}

uint64_t predict_mesh_bytes(const PreparedSummary& prepared, PreparedPlace place) {
  return mesh_bytes(prepared.byte_count, place, prepared.cells, prepared.vertices);
}

uint64_t predict_opened_bytes(const PreparationNeed& need, uint64_t device_bytes_max) {
  const PreparationCounts& counts = need.counts;
  const bool fits_devices = counts.cells <= device_bytes_max / kDeviceBytesPerCellMin;
  return mesh_bytes(need.file_bytes, place_of_prepared(need.file_bytes), counts.cells,
                    counts.vertices) +
         counts.cells * (fits_devices ? kHostBytesPerCellMin : kSessionBytesPerCellMin) +
         held_rims_bytes(counts.vertices, counts.triangles, counts.cells, 0);
}

}  // namespace burnish
