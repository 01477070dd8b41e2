#include "server/session/rim_anchor.h"

#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "common/evaluation/evaluation.h"
#include "server/solver/tuning/plan_cycle.h"
#include "tests/server/session/solved_session.h"

namespace burnish {
namespace {

constexpr int kDepth = 5;

/// An open square with bumps of one triangle, as a scanner's noise.
TriangleMesh rough_sheet() {
  TriangleMesh mesh = make_sheet(48, 1, 0.05);
  std::mt19937 random(3);
  for (Vec3d& v : mesh.vertices) v.z() += 2e-3 * (double(random()) / 2e9 - 1);
  return mesh;
}

double to_border(const Vec3d& p) {
  return std::min({p.x(), p.y(), 1 - p.x(), 1 - p.y()});
}

/// Returns the root mean square of the angles between triangles whose edges lie at these distances
/// from the border of the square.
double roughness(const TriangleMesh& mesh, const TriangleMesh& flat, double from, double to) {
  const auto normal = [&](const Triangle& t) {
    const auto& [a, b, c] = t;
    return (mesh.vertices[b] - mesh.vertices[a])
        .cross(mesh.vertices[c] - mesh.vertices[a])
        .normalized();
  };
  std::map<std::pair<uint32_t, uint32_t>, Vec3d> first;
  double sum = 0;
  int count = 0;
  for (const Triangle& t : mesh.triangles)
    for (int side = 0; side < 3; ++side) {
      const auto [a, b] = std::minmax(t[side], t[(side + 1) % 3]);
      const double at = to_border((flat.vertices[a] + flat.vertices[b]) / 2);
      if (at < from || at >= to) continue;
      const auto [there, is_new] = first.try_emplace({a, b}, normal(t));
      if (is_new) continue;
      const double angle = std::acos(std::clamp(there->second.dot(normal(t)), -1.0, 1.0));
      sum += angle * angle;
      ++count;
    }
  return std::sqrt(sum / count);
}

TEST(RimAnchor, TakesBackWhatRimsMoveAndNothingBeyondItsReach) {
  const auto session = session_over(make_sheet(48, 1, 0.05), kDepth, {.pin_rims = true});
  const PreparedMesh& prepared = session->prepared();
  const Multigrid on =
      make_multigrid(prepare(make_sheet(48, 1, 0.05), {.depth = kDepth}).value()).value();
  const SparseGrid& grid = on.hierarchy->at(on.hierarchy->finest).grid;
  RimAnchor anchor(prepared, grid, session->fields().rims());
  std::vector<Vec3f> displacement(grid.corners.size(), Vec3f(0.1f, -0.2f, 0.3f));
  anchor.apply(displacement);
  const double cell = prepared.frame.cell_size;
  for (size_t v = 0; v < prepared.vertices.size(); ++v) {
    const Vec3f moved = evaluate<Vec3f>(grid, prepared.evaluation[v], displacement);
    const double border = to_border(prepared.vertices[v]);
    if (border == 0) {
      EXPECT_LT(moved.norm(), 1e-6);
    }
    if (border > 6 * cell) {
      EXPECT_LT((moved - Vec3f(0.1f, -0.2f, 0.3f)).norm(), 1e-6);
    }
  }
}

TEST(RimAnchor, BesideAHeldRimASmoothedSurfaceIsSmootherThanTheScan) {
  const TriangleMesh scan = rough_sheet();
  const auto session = session_over(scan, kDepth, {.pin_rims = true});
  const TriangleMesh smoothed =
      exact_surface(*session, {SetTransferCurve{TransferCurve(20)}, SetGradientScale{0}});
  const double cell = session->prepared().frame.cell_size;
  EXPECT_LT(roughness(smoothed, scan, cell, 2 * cell), 0.7 * roughness(scan, scan, cell, 2 * cell));
  EXPECT_LT(roughness(smoothed, scan, 0, cell), 1.05 * roughness(scan, scan, 0, cell));
}

TEST(RimAnchor, ALooseFlakeStaysWhereItIs) {
  TriangleMesh mesh = make_sheet(48, 1, 0.05);
  const TriangleMesh flake = make_sheet(2, 0.06, 0.01);
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  for (const Vec3d& p : flake.vertices) mesh.vertices.push_back(p + Vec3d(0.5, 0.5, 0.4));
  for (const Triangle& t : flake.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  const TriangleMesh moved =
      exact_surface(*session_over(mesh, kDepth, {.pin_rims = true}),
                    {SetTransferCurve{TransferCurve(10)}, SetGradientScale{0}});
  for (size_t v = first; v < mesh.vertices.size(); ++v)
    EXPECT_LT((moved.vertices[v] - mesh.vertices[v]).norm(), 0.02) << v;
}

}  // namespace
}  // namespace burnish
