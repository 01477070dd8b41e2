#pragma once

#include <span>
#include <vector>

#include "client/scene/page_mesh.h"
#include "client/scene/page_rims.h"

namespace burnish {

/// A page as a picture shows it, and what it gives to the pages beside it.
struct DrawnPage {
  std::vector<PatchRange> patches;
  PageRim rim;
  std::vector<PageTriangle> at_rim;  ///< of triangles_at_rim()
  std::vector<Vec3f> still_sums;     ///< of sum_rim_normals(), before the displacement
  std::vector<Vec3f> moved_sums;     ///< of sum_rim_normals()
  std::vector<float> rim_ridges;     ///< of this page alone, one per rim vertex
  MovedPage moved;                   ///< normals of the rim are joined with other pages
  std::vector<float> ridges;         ///< one per vertex; those of the rim are joined
};

/// Begins to draw a page in another way than before. Needs: as find_rim().
DrawnPage begin_drawing(const PageMesh& mesh, std::span<const PatchRange> patches);

/// Moves the page by itself. Empty displacements: it is not moved. Units: as displace().
void move_drawn_page(DrawnPage& page, const PageMesh& mesh, std::span<const Vec3f> displacements,
                     float cell_size);

/// Makes the ridges of the page by itself from its normals.
void bend_drawn_page(DrawnPage& page, const PageMesh& mesh);

}  // namespace burnish
