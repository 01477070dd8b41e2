#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include <Eigen/Geometry>

#include "client/scene/draw_style.h"
#include "client/scene/page_mesh.h"
#include "client/scene/page_renderer.h"
#include "client/scene/page_space.h"
#include "common/base/status.h"
#include "common/mesh/statistics.h"

namespace burnish {

/// A file's own surface, which is shown until its session is there.
struct RawScan {
  std::filesystem::path file;
  uint64_t size_bytes = 0;
  uint64_t vertices = 0;
  uint64_t triangles = 0;
  bool has_colours = false;
  MeshStatistics statistics;
  Eigen::AlignedBox3d box;           ///< file units
  std::vector<PatchRange> patches;   ///< what draw() draws, once the pages are in the renderer
  std::vector<PageMesh> pages = {};  ///< until then
  PageSpace space = {};
};

/// Returns whether a file is shown before it is imported: its format is known and it is not too
/// large for this computer's memory.
bool can_be_raw(const std::filesystem::path& file);

/// Reads a mesh file for the screen: at most about `triangles_max` triangles are kept.
/// Fails: as read_mesh() does.
Result<RawScan> read_raw_scan(const std::filesystem::path& file, uint64_t triangles_max);

/// Moves the pages into an empty renderer. Fails: as the renderer does.
Status put_into(PageRenderer& renderer, RawScan& scan);

/// Returns the style of a raw scan: its own colours, else clay.
DrawStyle style_of(const RawScan& scan);

}  // namespace burnish
