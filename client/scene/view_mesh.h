#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "common/evaluation/evaluation.h"
#include "common/mesh/triangle_mesh.h"
#include "common/view/view.h"

namespace burnish {

/// A mesh in the form that a graphics card needs. Positions are floats around the box's centre in
/// units of half the box's diagonal, so that survey coordinates far from the origin keep their
/// detail.
struct ViewMesh {
  Eigen::AlignedBox3d box;       ///< of the referenced vertices, file units
  std::vector<Vec3f> positions;  ///< one per vertex
  std::vector<Vec3f> normals;    ///< one per vertex, unit length
  std::vector<float> ridges;     ///< one per vertex, within -1 (groove) to 1 (ridge)
  std::vector<Triangle> triangles;

  // Points that a session's displacement moves; all empty without a session.
  std::vector<EvaluationPoint> points;  ///< one per vertex
  std::vector<std::array<int32_t, kCornersPerCell>> cell_corners;
  int32_t corner_count = 0;
  float cell_size = 0;  ///< in half diagonals

  bool has_grid() const { return !points.empty(); }
  double unit() const { return 0.5 * box.diagonal().norm(); }  ///< file units
};

/// Needs: a valid mesh.
ViewMesh make_view_mesh(const TriangleMesh& mesh);

/// Makes the mesh of a session's view, with its grid.
ViewMesh make_view_mesh(const View& view);

}  // namespace burnish
