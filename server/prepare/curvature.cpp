#include "server/prepare/curvature.h"

#include <cmath>

#include "server/prepare/curvature_average.h"
#include "server/prepare/triangle_shape.h"

namespace burnish {

// Returns a power of two near the mesh's size: division by it keeps every bit and the range of
// products.
static double length_unit(const MeshStatistics& statistics) {
  return std::exp2(std::ceil(std::log2(statistics.diagonal())));
}

static TangentTensor mean_over_corners(const VertexCurvature& vertices, const Triangle& triangle,
                                       const TangentFrame& frame) {
  TangentTensor mean;
  for (uint32_t v : triangle) {
    if (!vertices.has_normal(v)) continue;
    mean.add(1.0 / 3, carry_tensor(vertices.tensors[v], make_frame(vertices.normals[v]), frame));
  }
  return mean;
}

MeshCurvature::MeshCurvature(const MeshView& mesh, const MeshStatistics& statistics,
                             double averaging_radius, const ScratchSpace& space,
                             const LoopPart& part)
    : mesh_(mesh), unit_(length_unit(statistics)) {
  vertices_ = compute_vertex_curvature(mesh, unit_, space, part.of(0, 0.5));
  if (averaging_radius > 0)
    vertices_.tensors =
        average_tensors(mesh, statistics, vertices_, averaging_radius, space, part.of(0.5, 1));
  vertices_.areas = {};
  const bool is_inside_out = statistics.is_closed() && statistics.signed_volume < 0;
  to_file_units_ = (is_inside_out ? -1 : 1) / unit_;
}

Vec3d MeshCurvature::normal_of(uint32_t triangle) const {
  Vec3d sum = Vec3d::Zero();
  for (uint32_t v : mesh_.triangles[triangle]) sum += vertices_.normals[v];
  return sum.normalized();
}

TriangleCurvature MeshCurvature::of(uint32_t index) const {
  const Triangle& triangle = mesh_.triangles[index];
  const TriangleShape shape = make_triangle_shape(mesh_, triangle, unit_);
  if (!shape.has_plane) return {};
  const TangentFrame frame = shape.frame();
  const PrincipalAxes axes =
      diagonalise(mean_over_corners(vertices_, triangle, frame).scaled(to_file_units_), frame);
  return {axes.kappa1, axes.kappa2, axes.v1, axes.v2};
}

}  // namespace burnish
