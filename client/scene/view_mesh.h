#pragma once

#include <span>
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

/// Returns unit normals: the mean of the adjacent triangles' normals, weighted by their angle at
/// the vertex. A vertex without a triangle of positive area gets (0, 0, 1).
/// Shapes: one per vertex.
std::vector<Vec3f> vertex_normals(std::span<const Vec3d> vertices,
                                  std::span<const Triangle> triangles);

/// Returns how much the surface bends at each vertex: the divergence of normals along its edges,
/// averaged twice over neighbours against noise, and mapped to -1 (groove) to 1 (ridge).
/// Shapes: one per vertex. Units: positions in half diagonals, as in ViewMesh.
std::vector<float> vertex_ridges(std::span<const Vec3f> positions, std::span<const Vec3f> normals,
                                 std::span<const Triangle> triangles);

}  // namespace burnish
