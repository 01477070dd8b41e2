#include "common/denoise/normal_filter.h"

#include <cstring>
#include <numbers>

#include <gtest/gtest.h>

#include "common/base/parallel.h"
#include "common/generate/generate.h"
#include "tests/common/odd_triangles.h"

namespace burnish {
namespace {

constexpr NormalFilterKind kKinds[] = {NormalFilterKind::kBilateral, NormalFilterKind::kEdges};

/// The arrays of a mesh that a filter needs.
struct Prepared {
  explicit Prepared(const TriangleMesh& mesh) : surface(mesh), rings(surface) {}
  WeldedSurface surface;
  TriangleRings rings;
};

std::vector<Vec3d> filtered(const TriangleMesh& mesh, NormalFilterKind kind, int passes) {
  const Prepared prepared(mesh);
  NormalFilter filter(prepared.surface, prepared.rings, kind, 0.3);
  for (int pass = 0; pass < passes; ++pass) filter.pass();
  std::vector<Vec3d> normals;
  for (const NormalAndArea& normal : filter.normals()) normals.push_back(normal_of(normal));
  return normals;
}

double largest_angle(const std::vector<Vec3d>& a, const std::vector<Vec3d>& b) {
  double largest = 0;
  for (size_t t = 0; t < a.size(); ++t) largest = std::max(largest, (a[t] - b[t]).norm());
  return largest * 180 / std::numbers::pi;
}

TEST(NormalFilter, BeginsWithTheNormalsOfTheTriangles) {
  const TriangleMesh mesh = make_icosphere(2, 3);
  const std::vector<Vec3d> normals = filtered(mesh, NormalFilterKind::kBilateral, 0);
  for (size_t t = 0; t < normals.size(); ++t) {
    const auto [a, b, c] = corners_of(mesh, t);
    EXPECT_LT((normals[t] - (b - a).cross(c - a).normalized()).norm(), 1e-6);
  }
}

TEST(NormalFilter, LeavesAFlatSurfaceAsItIs) {
  const TriangleMesh sheet = make_sheet(20, 5, 0);
  for (const NormalFilterKind kind : kKinds)
    for (const Vec3d& normal : filtered(sheet, kind, 20))
      EXPECT_LT((normal - Vec3d(0, 0, 1)).norm(), 1e-6);
}

/// Two flat sides of a right angle.
TriangleMesh folded_sheet() {
  TriangleMesh sheet = make_sheet(20, 2, 0);
  for (Vec3d& p : sheet.vertices)
    if (p.x() > 1) p = Vec3d(1, p.y(), p.x() - 1);
  return sheet;
}

TEST(NormalFilter, KeepsASharpEdge) {
  const TriangleMesh sheet = folded_sheet();
  for (const NormalFilterKind kind : kKinds)
    EXPECT_LT(largest_angle(filtered(sheet, kind, 20), filtered(sheet, kind, 0)), 0.1);
}

TEST(NormalFilter, NormalsHaveUnitLength) {
  const TriangleMesh wall = *generate_scan({"wall", 3000});
  for (const NormalFilterKind kind : kKinds)
    for (const Vec3d& normal : filtered(wall, kind, 3))
      EXPECT_NEAR(normal.norm(), normal.isZero() ? 0 : 1, 1e-6);
}

TEST(NormalFilter, TrianglesOfNoSurfaceChangeNothing) {
  const TriangleMesh mesh = *generate_scan({"icosphere", 162, 1, 0.2});
  for (const NormalFilterKind kind : kKinds) {
    const std::vector<Vec3d> expected = filtered(mesh, kind, 3);
    for (const auto& [name, odd] : with_triangles_of_no_surface(mesh)) {
      const std::vector<Vec3d> found = filtered(odd, kind, 3);
      for (size_t t = 0; t < found.size(); ++t)
        EXPECT_EQ(found[t], t < expected.size() ? expected[t] : Vec3d(0, 0, 0)) << name;
    }
  }
}

TEST(NormalFilter, HasTheSameBitsForAnyNumberOfThreads) {
  const TriangleMesh mesh = *generate_scan({"blob", 5000});
  const int before = thread_count();
  for (const NormalFilterKind kind : kKinds) {
    use_threads(1);
    const std::vector<Vec3d> expected = filtered(mesh, kind, 5);
    for (const int threads : {2, 3}) {
      use_threads(threads);
      EXPECT_EQ(filtered(mesh, kind, 5), expected) << threads << " threads";
    }
  }
  use_threads(before);
}

TEST(NormalFilter, RoundingChoosesNoOtherRing) {
  const TriangleMesh mesh = *generate_scan({"part", 3000, 1, 0.2});
  TriangleMesh near = mesh;
  for (size_t v = 0; v < near.vertices.size(); ++v)
    near.vertices[v].x() += v % 2 == 0 ? 1e-7 : -1e-7;  // edges are about 0.4
  for (const NormalFilterKind kind : kKinds)
    EXPECT_LT(largest_angle(filtered(mesh, kind, 10), filtered(near, kind, 10)), 0.05);
}

TEST(NormalFilter, ARestartIsLikeANewFilter) {
  const TriangleMesh mesh = *generate_scan({"blob", 1000});
  const Prepared prepared(mesh);
  for (const NormalFilterKind kind : kKinds) {
    NormalFilter used(prepared.surface, prepared.rings, kind, 0.6);
    used.pass();
    used.restart(0.3);
    used.pass();
    NormalFilter fresh(prepared.surface, prepared.rings, kind, 0.3);
    fresh.pass();
    EXPECT_EQ(
        std::memcmp(used.normals().data(), fresh.normals().data(), fresh.normals().size_bytes()),
        0);
  }
}

TEST(NormalFilter, HearsACancelAndKeepsItsNormals) {
  const TriangleMesh mesh = *generate_scan({"blob", 1000});
  const Prepared prepared(mesh);
  const Progress cancel = [](std::string_view, double) { return false; };
  for (const NormalFilterKind kind : kKinds) {
    NormalFilter filter(prepared.surface, prepared.rings, kind, 0.3);
    EXPECT_THROW(filter.pass({cancel, "normals"}), WorkCancelled);
    const auto normals = filter.normals();
    const auto fresh = triangle_normals(prepared.surface);
    EXPECT_EQ(std::memcmp(normals.data(), fresh.data(), normals.size_bytes()), 0);
    EXPECT_THROW(NormalFilter(prepared.surface, prepared.rings, kind, 0.3, {}, {cancel, "normals"}),
                 WorkCancelled);
  }
}

}  // namespace
}  // namespace burnish
