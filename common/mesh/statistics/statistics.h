#pragma once

#include <cstdint>

#include "common/base/record.h"
#include "common/base/scratch_space.h"
#include "common/base/types.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Facts that a user wants to know about a scan before editing it. An edge is an unordered pair of
/// places of vertices: seams of textures are no boundary. Triangles with two vertices at one place
/// have none, and copies of a triangle none besides its own (see SurfaceTriangles).
struct MeshStatistics {
  uint64_t vertices = 0;
  uint64_t triangles = 0;
  uint64_t boundary_edges = 0;       ///< edges of exactly one triangle
  uint64_t non_manifold_edges = 0;   ///< edges of three or more triangles
  uint64_t components = 0;           ///< of the referenced vertices, connected through edges
  uint64_t zero_area_triangles = 0;  ///< exactly zero, in double precision
  uint64_t unreferenced_vertices = 0;
  double area = 0;                ///< file units squared
  double signed_volume = 0;       ///< file units cubed; means something only when closed: an
                                  ///< open surface is closed through the box's centre
  double mean_edge_length = 0;    ///< over unordered edges, file units
  Vec3d box_min = Vec3d::Zero();  ///< of the referenced vertices
  Vec3d box_max = Vec3d::Zero();

  bool is_closed() const { return boundary_edges == 0; }
  double diagonal() const { return (box_max - box_min).norm(); }
};

BURNISH_RECORD(MeshStatistics, vertices, triangles, boundary_edges, non_manifold_edges, components,
               zero_area_triangles, unreferenced_vertices, area, signed_volume, mean_edge_length)

/// Needs: a valid mesh, and the same mesh joined. Cost: near linear time; scratch of 13 bytes per
/// triangle and 8 per vertex, which lies in `space`.
MeshStatistics compute_statistics(const MeshView& mesh, const MeshView& joined,
                                  const ScratchSpace& space);
/// Does the same; joins the mesh for it.
MeshStatistics compute_statistics(const MeshView& mesh, const ScratchSpace& space = {});

}  // namespace burnish
