#pragma once

#include <span>
#include <vector>

#include "client/scene/page_mesh.h"
#include "client/scene/page_renderer.h"
#include "common/base/groups.h"

namespace burnish {

/// The drawn vertices of a page that other drawn pages may have as well: those of its border, and
/// those between its drawn triangles and the others, which finer pages replace.
using PageRim = std::vector<uint16_t>;

/// Needs: ranges inside the page that do not overlap.
PageRim find_rim(const PageMesh& mesh, std::span<const PatchRange> drawn);

/// Returns the drawn triangles that have a rim vertex.
std::vector<PageTriangle> triangles_at_rim(const PageMesh& mesh, std::span<const PatchRange> drawn,
                                           const PageRim& rim);

/// Returns what sum_corner_normals() makes of the triangles at the rim. Shapes: one sum per rim
/// vertex.
std::vector<Vec3f> sum_rim_normals(std::span<const Vec3f> positions,
                                   std::span<const PageTriangle> at_rim, const PageRim& rim);

/// A vertex of a rim, in a list of pages.
struct RimPlace {
  uint32_t page = 0;   ///< in the list
  uint32_t index = 0;  ///< in the page's rim
};

/// A page and its rim.
struct RimmedPage {
  const PageMesh* mesh = nullptr;
  const PageRim* rim = nullptr;
};

/// Groups the rim vertices that are the same lattice point. Cost: O(rim vertices).
Groups<RimPlace> group_rims(std::span<const RimmedPage> pages);

}  // namespace burnish
