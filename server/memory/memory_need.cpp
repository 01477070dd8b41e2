#include "server/memory/memory_need.h"

#include <algorithm>

#include "common/frame_codec/frame_encoder.h"

namespace burnish {

static constexpr uint64_t kSessionBytesPerCorner = 700;  // of any depth
static constexpr uint64_t kSessionBytesPerCell = 60;     // fields, paint, a gesture's copy
static constexpr uint64_t kLayoutBytesPerValue = 12;
static constexpr uint64_t kFrameInTheMaking = 36;    // per value: its sample, two drafts, its bytes
static constexpr uint64_t kCoarsestBytes = 6 << 20;  // the direct solver of the coarsest depth

uint64_t predict_session_bytes(const Multigrid& on) {
  const Hierarchy& hierarchy = *on.hierarchy;
  uint64_t bytes = kCoarsestBytes;
  for (const HierarchyDepth& depth : hierarchy.depths)
    bytes += depth.grid.corners.size() * kSessionBytesPerCorner;
  const HierarchyDepth& finest = hierarchy.at(hierarchy.finest);
  return bytes + finest.grid.cells.size() * kSessionBytesPerCell +
         on.plan->patches.entry_count() * sizeof(float);
}

// A client may ask for either content, so the larger one counts.
uint64_t predict_target_bytes(const PreparedMesh& prepared, const Hierarchy& hierarchy,
                              uint64_t triangles_max) {
  const uint64_t corners = hierarchy.at(hierarchy.finest).grid.corners.size();
  const uint64_t vertices = prepared.vertices.size();
  if (triangles_max == 0) return std::max(corners, vertices) * kLayoutBytesPerValue;
  const uint64_t points = std::min(vertices, 3 * triangles_max);
  return std::max(corners, points) * kLayoutBytesPerValue + points * sizeof(EvaluationPoint);
}

uint64_t predict_client_bytes(const FrameLayout& layout) {
  return FrameEncoder::byte_count_max(layout) + kFrameInTheMaking * layout.value_count();
}

uint64_t predict_proxy_bytes(const PreparedMesh& prepared) {
  return prepared.vertices.size() * 24 + prepared.triangles.size() * 40;
}

}  // namespace burnish
