#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/base/status.h"
#include "common/base/types.h"

namespace burnish {

/// The number of a page in its scan. Numbers rise from fine to coarse levels: level 0 begins at 0,
/// and the root is the last page. So a page's number is known as soon as it is made.
using PageId = uint32_t;
inline constexpr PageId kNoPage = 0xffffffff;

/// Vertices of a page.
using PageTriangle = std::array<uint16_t, 3>;

/// Triangles of a page that replace one finer page together with other pages' patches.
struct PagePatch {
  PageId finer = kNoPage;  ///< kNoPage at level 0: nothing is finer
  uint32_t triangles = 0;  ///< at least 1
  bool operator==(const PagePatch&) const = default;
};

/// A piece of a scan's surface at one level of detail. Pictures draw it patch by patch.
struct Page {
  PageId id = 0;
  std::vector<PagePatch> patches;       ///< `finer` rises strictly
  std::vector<PageTriangle> triangles;  ///< patch by patch
  std::vector<Vec3i> positions;         ///< steps of PageGrid; every vertex has a triangle
  /// How many of the first vertices other pages of the level have as well.
  uint32_t border_vertices = 0;
  /// Unit length. One per border vertex, or one per vertex. Those of border vertices have the same
  /// bits in every page of the level. Without its own, a vertex inside has that of its triangles.
  std::vector<Vec3f> normals;
  std::vector<Rgba8> colours;  ///< empty, or one per vertex

  bool has_all_normals() const { return normals.size() == positions.size(); }
};

/// Checks all that a page promises by itself. Fails: invalid_argument that names the page, the
/// thing, its value and its limit.
Status check_page(const Page& page);

}  // namespace burnish
