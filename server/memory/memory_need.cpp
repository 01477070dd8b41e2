#include "server/memory/memory_need.h"

#include "common/evaluation/evaluation.h"
#include "common/page_frames/page_frame_encoder.h"
#include "server/fields/rims.h"

namespace burnish {

static constexpr uint64_t kSessionBytesPerCorner = 700;  // of any depth
static constexpr uint64_t kSessionBytesPerCell = 60;     // fields, paint, a gesture's copy
static constexpr uint64_t kShownBytesPerCorner = 48;     // of the finest depth, with all controls
static constexpr uint64_t kFrameInTheMaking = 36;    // per value: its sample, two drafts, its bytes
static constexpr uint64_t kPageBytes = 512;          // of a page's own, without its values
static constexpr uint64_t kBytesPerEdgeVertex = 16;  // its number and position
static constexpr uint64_t kPageInLists = 128;        // of a client: wanted, made and shown pages
static constexpr uint64_t kCoarsestBytes = 6 << 20;  // the direct solver of the coarsest depth
// Numbers read from devices, once for each device and once together.
static constexpr uint64_t kReadBytesPerCorner = 2 * sizeof(Vec3f);
static constexpr uint64_t kReadBytesPerVertex = 2 * sizeof(Vec3f);
static constexpr uint64_t kShardBytesPerCorner = 16;  // which corners, cells and vertices it has

// Returns the bytes of fields, paint, rims and what is shown.
static uint64_t predict_edited_bytes(const Multigrid& on) {
  const SparseGrid& finest = on.hierarchy->at(on.hierarchy->finest).grid;
  const PreparedMesh& scan = *on.prepared;
  return finest.corners.size() * kShownBytesPerCorner + finest.cells.size() * kSessionBytesPerCell +
         held_rims_bytes(scan.vertices.size(), scan.triangles.size(), scan.cells.size(),
                         scan.statistics.boundary_edges);
}

uint64_t predict_session_bytes(const Multigrid& on) {
  uint64_t bytes = kCoarsestBytes + predict_edited_bytes(on);
  for (const HierarchyDepth& depth : on.hierarchy->depths)
    bytes += depth.grid.corners.size() * kSessionBytesPerCorner;
  return bytes + on.plan->patches.entry_count() * sizeof(float);
}

SessionNeed predict_session_need(const Multigrid& on, int devices) {
  if (devices == 0) return {predict_session_bytes(on), predict_session_bytes(on)};
  const SparseGrid& finest = on.hierarchy->at(on.hierarchy->finest).grid;
  uint64_t bytes = kCoarsestBytes + predict_edited_bytes(on) +
                   finest.corners.size() * kReadBytesPerCorner +
                   on.prepared->vertices.size() * kReadBytesPerVertex;
  if (devices == 1) return {bytes, bytes};
  bytes += finest.corners.size() * kShardBytesPerCorner;
  return {bytes + on.hierarchy->byte_count() + on.prepared->byte_count(), bytes};
}

uint64_t predict_page_bytes(const PageSize& page, PageFrameKind kind) {
  const bool has_corners = kind == PageFrameKind::kCorners;
  const uint64_t values = has_corners ? page.corners : page.vertices;
  // A vertex has a predictor for each edge to an earlier vertex, or one. A corner has three at
  // most.
  const uint64_t predictors = has_corners ? 3 * values : values + uint64_t{3} * page.triangles;
  constexpr uint64_t kGrowth = 2;  // of a vector that grows by itself
  const uint64_t colours = has_corners ? 0 : page.vertices * sizeof(Rgba8);
  return kPageBytes + colours + values * sizeof(EvaluationPoint) + page.vertices * sizeof(int32_t) +
         page.edge_vertices * kBytesPerEdgeVertex + held_bytes(page.vertices) +
         kGrowth * (values + predictors) * sizeof(uint16_t);
}

uint64_t predict_client_bytes(std::span<const ShownPage> pages) {
  uint64_t values = 0;
  for (const ShownPage& page : pages) values += page.value_count();
  return PageFrameEncoder::byte_count_max(pages) + kPageInLists * pages.size() +
         kFrameInTheMaking * values;
}

}  // namespace burnish
