#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "client/scene/page_mesh.h"
#include "client/scene/page_renderer.h"
#include "client/scene/page_space.h"
#include "common/base/status.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// A mesh without a session, in pages that are near each other in space. Nothing moves them.
struct RawPages {
  PageSpace space;                       ///< as a session on the mesh has it
  Eigen::AlignedBox3d box;               ///< of the referenced vertices, file units
  std::vector<PageMesh> pages;           ///< each within kPageVerticesMax and kPageTrianglesMax
  std::vector<uint32_t> triangles = {};  ///< of the mesh, page by page; empty if it is thinned
};

/// Returns the box of the vertices that triangles reference, file units.
Eigen::AlignedBox3d referenced_box(const TriangleMesh& mesh);

/// Returns the space of a mesh's raw pages. `box`: referenced_box().
PageSpace raw_page_space(const Eigen::AlignedBox3d& box);

/// Cuts a mesh. Vertices of several pages have the same bits in each: position, normal, ridge and
/// colour are those of the whole mesh. A mesh with more than `triangles_max` triangles is thinned.
/// Needs: a valid mesh. Cost: O(vertices + triangles).
RawPages make_raw_pages(const TriangleMesh& mesh,
                        uint64_t triangles_max = std::numeric_limits<uint64_t>::max());

/// The same for a mesh whose triangles show texels: so many for each triangle. The triangles of a
/// page have `texels_max` in all, but for one alone that has more. A page with a denser part ends
/// where a sheet that is as dense everywhere has no room. Needs: one number per triangle.
RawPages make_raw_pages(const TriangleMesh& mesh, std::span<const float> texels, double texels_max);

/// Puts page i into slot i. Returns what draw() needs to draw all of them.
/// Fails: resource_exhausted.
Result<std::vector<PatchRange>> upload_pages(const RawPages& raw, PageRenderer& renderer);

}  // namespace burnish
