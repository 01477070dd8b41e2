#include "server/prepare/vertex_curvature.h"

#include "server/prepare/triangle_shape.h"

namespace burnish {

static constexpr double kCancelledNormal = 1e-12;  // of the sum of the parts' lengths

namespace {

/// The triangles around each vertex, rising, so that sums over them do not depend on the number of
/// threads. A triangle that repeats a vertex is there once per corner.
class VertexTriangles {
 public:
  /// Throws: WorkCancelled.
  VertexTriangles(const MeshView& mesh, const ScratchSpace& space,
                  const LoopPart& part = kUnheardLoop);

  std::span<const uint32_t> operator[](size_t vertex) const {
    return {triangles_.data() + start_[vertex], triangles_.data() + start_[vertex + 1]};
  }

 private:
  ScratchArray<uint64_t> start_;
  ScratchArray<uint32_t> triangles_;
};

// Counts a vertex two places further up, so that filling moves each start to its own place.
VertexTriangles::VertexTriangles(const MeshView& mesh, const ScratchSpace& space,
                                 const LoopPart& part)
    : start_(space, mesh.vertices.size() + 2), triangles_(space, 3 * mesh.triangles.size()) {
  for_each_heard(part.of(0, 0.3), mesh.triangles.size(), [&](size_t t) {
    for (const uint32_t v : mesh.triangles[t]) ++start_[v + 2];
  });
  for_each_heard(part.of(0.3, 0.4), mesh.vertices.size(),
                 [&](size_t v) { start_[v + 2] += start_[v + 1]; });
  for_each_heard(part.of(0.4, 1), mesh.triangles.size(), [&](size_t t) {
    for (const uint32_t v : mesh.triangles[t])
      triangles_[start_[v + 1]++] = static_cast<uint32_t>(t);
  });
}

}  // namespace

static int corner_of(const Triangle& triangle, uint32_t vertex) {
  return triangle[0] == vertex ? 0 : triangle[1] == vertex ? 1 : 2;
}

// Calls visit(triangle index, shape, corner) for the triangles with a plane around a vertex.
template <typename Visit>
static void for_each_corner(const MeshView& mesh, const VertexTriangles& vertex_triangles,
                            size_t vertex, double unit, Visit visit) {
  for (uint32_t t : vertex_triangles[vertex]) {
    const Triangle& triangle = mesh.triangles[t];
    const TriangleShape shape = make_triangle_shape(mesh, triangle, unit);
    if (shape.has_plane) visit(t, shape, corner_of(triangle, static_cast<uint32_t>(vertex)));
  }
}

static ScratchArray<Vec3d> vertex_normals(const MeshView& mesh,
                                          const VertexTriangles& vertex_triangles, double unit,
                                          const ScratchSpace& space, const LoopPart& part) {
  ScratchArray<Vec3d> normals(space, mesh.vertices.size());
  parallel_for_heard(part, normals.size(), [&](size_t v) {
    Vec3d sum = Vec3d::Zero();
    double length = 0;
    for_each_corner(mesh, vertex_triangles, v, unit,
                    [&](uint32_t, const TriangleShape& shape, int corner) {
                      const double weight = shape.normal_weight(corner);
                      sum += weight * shape.cross;
                      length += weight * shape.twice_area;
                    });
    const double norm = sum.norm();
    normals[v] = norm > kCancelledNormal * length ? Vec3d(sum / norm) : Vec3d::Zero();
  });
  return normals;
}

// Returns the tensor II with II·edge = difference of the normals along it, by least squares over
// the three edges: a tridiagonal system for uu, uv, vv.
static TangentTensor second_fundamental_form(const TriangleShape& shape, const TangentFrame& frame,
                                             const std::array<Vec3d, 3>& normals) {
  double xx = 0, xy = 0, yy = 0;
  double right0 = 0, right1 = 0, right2 = 0;
  for (int k = 0; k < 3; ++k) {
    const double x = shape.edges[k].dot(frame.u), y = shape.edges[k].dot(frame.v);
    const Vec3d turn = normals[(k + 2) % 3] - normals[(k + 1) % 3];
    const double turn_u = turn.dot(frame.u), turn_v = turn.dot(frame.v);
    xx += x * x;
    xy += x * y;
    yy += y * y;
    right0 += turn_u * x;
    right1 += turn_u * y + turn_v * x;
    right2 += turn_v * y;
  }
  const double pivot0 = xx;
  const double pivot1 = xx + yy - xy * xy / pivot0;
  const double pivot2 = yy - xy * xy / pivot1;
  right1 -= xy / pivot0 * right0;
  right2 -= xy / pivot1 * right1;
  TangentTensor form;
  form.vv = right2 / pivot2;
  form.uv = (right1 - xy * form.vv) / pivot1;
  form.uu = (right0 - xy * form.uv) / pivot0;
  return form;
}

// In the triangles' own frames; zero for a triangle without a plane.
static ScratchArray<TangentTensor> triangle_tensors(const MeshView& mesh,
                                                    const ScratchArray<Vec3d>& normals, double unit,
                                                    const ScratchSpace& space,
                                                    const LoopPart& part) {
  ScratchArray<TangentTensor> tensors(space, mesh.triangles.size());
  parallel_for_heard(part, tensors.size(), [&](size_t t) {
    const Triangle& triangle = mesh.triangles[t];
    const TriangleShape shape = make_triangle_shape(mesh, triangle, unit);
    tensors[t] = {};
    if (!shape.has_plane) return;
    tensors[t] = second_fundamental_form(
        shape, shape.frame(), {normals[triangle[0]], normals[triangle[1]], normals[triangle[2]]});
  });
  return tensors;
}

VertexCurvature compute_vertex_curvature(const MeshView& mesh, double unit,
                                         const ScratchSpace& space, const LoopPart& part) {
  const VertexTriangles vertex_triangles(mesh, space, part.of(0, 0.2));
  VertexCurvature result;
  result.normals = vertex_normals(mesh, vertex_triangles, unit, space, part.of(0.2, 0.5));
  result.tensors = ScratchArray<TangentTensor>(space, mesh.vertices.size());
  result.areas = ScratchArray<double>(space, mesh.vertices.size());
  const ScratchArray<TangentTensor> of_triangles =
      triangle_tensors(mesh, result.normals, unit, space, part.of(0.5, 0.7));
  parallel_for_heard(part.of(0.7, 1), mesh.vertices.size(), [&](size_t v) {
    if (!result.has_normal(v)) return;
    const TangentFrame frame = make_frame(result.normals[v]);
    TangentTensor sum;
    double area = 0;
    for_each_corner(mesh, vertex_triangles, v, unit,
                    [&](uint32_t t, const TriangleShape& shape, int corner) {
                      const double weight = shape.voronoi_area(corner);
                      sum.add(weight, carry_tensor(of_triangles[t], shape.frame(), frame));
                      area += weight;
                    });
    result.tensors[v] = sum.scaled(1 / area);
    result.areas[v] = area;
  });
  return result;
}

}  // namespace burnish
