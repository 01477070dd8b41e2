#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "client/scene/draw_style.h"
#include "client/scene/page_mesh.h"
#include "client/scene/page_renderer.h"
#include "client/scene/page_space.h"
#include "client/scene/up_axis.h"
#include "common/base/status.h"
#include "common/mesh/statistics/statistics.h"

namespace burnish {

class Connection;

/// The surface of a scan without a session, which is shown until its session is there: a file's
/// own, or a coarse one of a server's scan.
struct RawScan {
  std::string name;            ///< as users know it
  std::filesystem::path file;  ///< empty: the scan is a server's
  uint64_t size_bytes = 0;
  uint64_t vertices = 0;
  uint64_t triangles = 0;
  bool has_colours = false;
  MeshStatistics statistics;
  Eigen::AlignedBox3d box;           ///< file units
  UpAxis up = UpAxis::kY;            ///< likely_up()
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

/// Fetches a coarse surface of a server's scan: a level of its pages that one request brings, at
/// most about `triangles_max` triangles.
/// `is_wanted` is asked between pages. Fails: as the server says; data_loss; cancelled if it is not
/// wanted any more.
Result<RawScan> fetch_raw_scan(Connection& connection, const std::string& scan,
                               uint64_t triangles_max, const std::function<bool()>& is_wanted);

/// Moves the pages into an empty renderer. Fails: as the renderer does.
Status put_into(PageRenderer& renderer, RawScan& scan);

/// Returns the style of a raw scan: its own colours, else clay.
DrawStyle style_of(const RawScan& scan);

/// Returns how many triangles its pictures have. Needs: put_into().
uint64_t drawn_triangles(const RawScan& scan);

}  // namespace burnish
