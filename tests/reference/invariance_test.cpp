#include <gtest/gtest.h>

#include "tests/reference/compare.h"
#include "tests/reference/reference.h"
#include "tests/reference/shapes.h"

namespace burnish::reference {
namespace {

/// A curve of contrast 100 over the curvatures of a bumpy sphere.
TransferCurve contrasting_curve() {
  return TransferCurve::parse("-10:200,4:4,20:400").value();
}

std::vector<Vec3d> filtered(const TriangleMesh& mesh, int depth) {
  const System system = build(mesh, depth);
  return edited_vertices(system, fields(system, contrasting_curve(), 0));
}

/// Filters the mapped mesh and compares with the mapped result.
template <typename Map>
double difference_under(const Map& map) {
  const TriangleMesh mesh = bumpy_sphere(4);
  const TriangleMesh moved = mapped(mesh, map);
  const TriangleMesh expected = mapped({filtered(mesh, 5), mesh.triangles}, map);
  return vertex_distance(filtered(moved, 5), expected.vertices, box_diagonal(moved)).max;
}

TEST(ReferenceInvariance, ScaleAndShift) {
  EXPECT_LT(difference_under([](const Vec3d& p) { return Vec3d(1000 * p + Vec3d(10, -20, 5)); }),
            1e-6);
  EXPECT_LT(difference_under([](const Vec3d& p) { return Vec3d(1e-3 * p); }), 1e-6);
}

TEST(ReferenceInvariance, QuarterTurnsAndReflections) {
  EXPECT_LT(difference_under([](const Vec3d& p) { return Vec3d(-p.y(), p.x(), p.z()); }), 1e-6);
  EXPECT_LT(difference_under([](const Vec3d& p) { return Vec3d(p.z(), p.y(), -p.x()); }), 1e-6);
  // A reflection turns the closed surface inside out; the curvatures must not depend on it.
  EXPECT_LT(difference_under([](const Vec3d& p) { return Vec3d(-p.x(), p.y(), p.z()); }), 1e-6);
}

TEST(ReferenceInvariance, ReversedWindingOfAClosedMesh) {
  const TriangleMesh mesh = bumpy_sphere(4);
  const Distance distance =
      vertex_distance(filtered(turned_inside_out(mesh), 5), filtered(mesh, 5), box_diagonal(mesh));
  EXPECT_LT(distance.max, 1e-9);
}

TEST(ReferenceInvariance, TheCurveMattersSoTheOthersCompareSomething) {
  const TriangleMesh mesh = bumpy_sphere(4);
  const System system = build(mesh, 5);
  const std::vector<Vec3d> plain = edited_vertices(system, fields(system, TransferCurve(40), 0));
  EXPECT_GT(vertex_distance(plain, filtered(mesh, 5), box_diagonal(mesh)).max, 5e-3);
}

TEST(ReferenceInvariance, DepthsConvergeOnASmoothClosedShape) {
  const TriangleMesh mesh = bumpy_sphere(5);
  std::vector<std::vector<Vec3d>> edited;
  for (int depth : {4, 5, 6}) {
    const System system = build(mesh, depth);
    edited.push_back(edited_vertices(system, fields(system, TransferCurve(20), 0)));
  }
  const double diagonal = box_diagonal(mesh);
  const Distance coarse = vertex_distance(edited[0], edited[1], diagonal);
  const Distance fine = vertex_distance(edited[1], edited[2], diagonal);
  EXPECT_LT(fine.rms, coarse.rms / 2.5);
  EXPECT_LT(fine.max, 1e-3);
}

}  // namespace
}  // namespace burnish::reference
