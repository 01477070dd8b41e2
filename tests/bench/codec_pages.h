#pragma once

#include <span>
#include <vector>

#include "common/grid/sparse_grid.h"
#include "common/page_frames/page_kind.h"
#include "common/pages/page.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// The pages of one level of a scan. Together they are the whole surface.
struct PageLevel {
  int level = 0;
  int bits = 0;  ///< of the lattice
  std::vector<Page> pages;
};

/// Builds the pages of a scan and reads every other level back.
std::vector<PageLevel> build_page_levels(const PreparedMesh& prepared);

/// What frames of one client cost that shows all pages of a level.
struct PageFrameCost {
  PageFrameKind kind;
  int step_shift;
  uint64_t values = 0;
  size_t key_bytes = 0;
  size_t change_bytes = 0;
  double sample_ms = 0;  ///< of the change, as below; on one core
  double encode_ms = 0;
  double decode_ms = 0;
};

/// Sends `before` as a key frame, then the change to `after`. Shapes: one displacement per corner.
PageFrameCost page_frame_cost(const PageLevel& level, const SparseGrid& grid, PageFrameKind kind,
                              int step_shift, std::span<const Vec3f> before,
                              std::span<const Vec3f> after);

}  // namespace burnish
