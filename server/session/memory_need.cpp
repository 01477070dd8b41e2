#include "server/session/memory_need.h"

namespace burnish {

// Measured on real scans and rounded up: a cell of the finest depth brings some two corners, and
// the coarser depths a third of that again (ARCHITECTURE section 7 has the figures).
static constexpr uint64_t kHierarchyBytesPerCell = 700;
static constexpr uint64_t kSessionBytesPerCorner = 700;  // of any depth
static constexpr uint64_t kSessionBytesPerCell = 40;     // fields and paint
static constexpr uint64_t kCoarsestBytes = 6 << 20;      // the direct solver of the coarsest depth

uint64_t predict_mesh_bytes(const PreparedMesh& prepared) {
  return prepared.byte_count() + prepared.cells.size() * kHierarchyBytesPerCell;
}

uint64_t predict_session_bytes(const Hierarchy& hierarchy) {
  uint64_t bytes = kCoarsestBytes;
  for (const HierarchyDepth& depth : hierarchy.depths)
    bytes += depth.grid.corners.size() * kSessionBytesPerCorner;
  return bytes + hierarchy.at(hierarchy.finest).grid.cells.size() * kSessionBytesPerCell;
}

}  // namespace burnish
