#include "server/prepare/curvature.h"

#include <cmath>

#include "server/prepare/curvature_average.h"
#include "server/prepare/triangle_shape.h"
#include "server/prepare/vertex_curvature.h"

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

UnsetVector<TriangleCurvature> compute_curvature(const TriangleMesh& mesh,
                                                 const MeshStatistics& statistics,
                                                 double averaging_radius) {
  const double unit = length_unit(statistics);
  VertexCurvature vertices = compute_vertex_curvature(mesh, unit);
  if (averaging_radius > 0)
    vertices.tensors = average_tensors(mesh, statistics, vertices, averaging_radius);

  const bool is_inside_out = statistics.is_closed() && statistics.signed_volume < 0;
  const double to_file_units = (is_inside_out ? -1 : 1) / unit;
  UnsetVector<TriangleCurvature> curvature(mesh.triangles.size());
#pragma omp parallel for schedule(static)
  for (int64_t t = 0; t < static_cast<int64_t>(curvature.size()); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    const TriangleShape shape = make_triangle_shape(mesh, triangle, unit);
    curvature[t] = {};
    if (!shape.has_plane) continue;
    const TangentFrame frame = shape.frame();
    const PrincipalAxes axes =
        diagonalise(mean_over_corners(vertices, triangle, frame).scaled(to_file_units), frame);
    curvature[t] = {axes.kappa1, axes.kappa2, axes.v1, axes.v2};
  }
  return curvature;
}

}  // namespace burnish
