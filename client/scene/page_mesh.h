#pragma once

#include <span>
#include <vector>

#include "common/pages/page.h"
#include "common/pages/page_grid.h"

namespace burnish {

/// A page in the form that a picture needs, in the units of PageSpace.
struct PageMesh {
  std::vector<Vec3f> positions;  ///< one per vertex; the same lattice point gives the same floats
  std::vector<Vec3f> normals;    ///< one per vertex, unit length
  /// Results of sum_corner_normals() for this page's triangles, for the first vertices, whose
  /// normals the page carries.
  std::vector<Vec3f> own_sums;
  uint32_t border_vertices = 0;         ///< as in Page
  std::vector<float> ridges;            ///< one per vertex, of vertex_ridges()
  std::vector<PageTriangle> triangles;  ///< patch by patch, as in Page
  std::vector<Rgba8> colours;           ///< empty, or one per vertex
};

/// Takes the normals that the page carries. Other vertices get the mean of the page's triangles,
/// as vertex_normals() does; without area (0, 0, 1). Needs: check_page() is ok.
PageMesh make_page_mesh(const Page& page, const PageGrid& grid);

/// A page with a displacement.
struct MovedPage {
  std::vector<Vec3f> positions;  ///< one per vertex
  std::vector<Vec3f> normals;    ///< one per vertex, unit length
};

/// Moves the vertices. The same lattice point and displacement give the same floats in all pages.
/// Normals turn as those of this page's triangles do; they stay where the triangles have no area.
/// One page alone says too little at its borders: PageSurface joins them.
/// Shapes: one displacement per vertex. Units: displacements in cells, `cell_size` in PageSpace.
MovedPage displace(const PageMesh& mesh, std::span<const Vec3f> displacements, float cell_size);

}  // namespace burnish
