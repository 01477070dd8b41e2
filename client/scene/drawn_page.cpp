#include "client/scene/drawn_page.h"

#include "client/scene/ridges.h"

namespace burnish {

DrawnPage begin_drawing(const PageMesh& mesh, std::span<const PatchRange> patches) {
  DrawnPage page;
  page.patches.assign(patches.begin(), patches.end());
  page.rim = find_rim(mesh, patches);
  page.at_rim = triangles_at_rim(mesh, patches, page.rim);
  page.still_sums = sum_rim_normals(mesh.positions, page.at_rim, page.rim);
  return page;
}

void move_drawn_page(DrawnPage& page, const PageMesh& mesh, std::span<const Vec3f> displacements,
                     float cell_size) {
  if (displacements.empty()) {
    page.moved = {mesh.positions, mesh.normals};
    page.moved_sums = page.still_sums;
    return;
  }
  page.moved = displace(mesh, displacements, cell_size);
  page.moved_sums = sum_rim_normals(page.moved.positions, page.at_rim, page.rim);
}

void bend_drawn_page(DrawnPage& page, const PageMesh& mesh) {
  const bool is_still =
      page.moved.normals == mesh.normals && page.moved.positions == mesh.positions;
  page.ridges = is_still ? mesh.ridges
                         : vertex_ridges(page.moved.positions, page.moved.normals, mesh.triangles);
  page.rim_ridges.clear();
  for (const uint16_t vertex : page.rim) page.rim_ridges.push_back(page.ridges[vertex]);
}

}  // namespace burnish
