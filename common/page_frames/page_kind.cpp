#include "common/page_frames/page_kind.h"

#include "common/packing/group_packing.h"

namespace burnish {

size_t page_key_bytes_max(uint32_t values) {
  constexpr size_t kFlagAndGain = 2;
  return kFlagAndGain + 3 * axis_bytes_max(static_cast<int>(values));
}

PageFrameKind cheaper_kind(uint64_t vertices, uint64_t corners) {
  // Measured on scans (codec_bench): a corner takes about as many bytes as 1.4 vertices, because
  // its neighbours are further away.
  constexpr uint64_t kCornerCost = 14, kVertexCost = 10;
  return corners * kCornerCost < vertices * kVertexCost ? PageFrameKind::kCorners
                                                        : PageFrameKind::kVertices;
}

}  // namespace burnish
