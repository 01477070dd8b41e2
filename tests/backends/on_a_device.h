#pragma once

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "common/mesh/statistics/statistics.h"
#include "server/prepare/prepare.h"
#include "server/solver/cuda/cuda_backend.h"
#include "server/solver/solver.h"
#include "server/solver/tuning/plan_cycle.h"
#include "tests/reference/compare.h"

namespace burnish {

/// A fact that needs a device, and is skipped without one.
class OnADevice : public testing::Test {
 protected:
  void SetUp() override {
    const auto device = cuda_device();
    if (!device.is_ok()) GTEST_SKIP() << device.status().message();
  }
};

/// Returns the largest distance of a vertex over the diagonal; NaN if one is no number.
inline double largest_distance(const std::vector<Vec3d>& a, const std::vector<Vec3d>& b,
                               const TriangleMesh& mesh) {
  return reference::vertex_distance(a, b, compute_statistics(mesh).diagonal()).max;
}

inline std::shared_ptr<const PreparedMesh> small_scan() {
  return prepare(generate_scan({.kind = "icosphere", .vertices = 600}).value(), {.depth = 5})
      .value();
}

inline Result<std::unique_ptr<Solver>> open_solver(const SolverOptions& options) {
  return Solver::create(make_multigrid(small_scan()).value(), options);
}

/// Adds a piece to a mesh, moved by `at`.
inline void append(const TriangleMesh& piece, const Vec3d& at, TriangleMesh& mesh) {
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  for (const Vec3d& vertex : piece.vertices) mesh.vertices.push_back(vertex + at);
  for (const Triangle& t : piece.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

/// Two spheres through each other: cells where they meet have two components of the mesh.
inline TriangleMesh crossing_spheres() {
  const TriangleMesh sphere = generate_scan({.kind = "icosphere", .vertices = 5000}).value();
  TriangleMesh mesh = sphere;
  append(sphere, 0.7 * compute_statistics(sphere).diagonal() * Vec3d(0.5, 0.1, 0.2), mesh);
  return mesh;
}

/// Returns 512 small spheres apart from each other.
inline TriangleMesh separate_pieces() {
  TriangleMesh mesh;
  const TriangleMesh piece = generate_scan({.kind = "icosphere", .vertices = 12}).value();
  for (int i = 0; i < 512; ++i) append(piece, 4 * Vec3d(i % 8, i / 8 % 8, i / 64), mesh);
  return mesh;
}

/// At this depth a piece is too large for a patch, so that it keeps its coarse cells.
inline constexpr int kDepthOfPieces = 7;

/// The same pieces below a tablet, which has its own sheets.
inline TriangleMesh separate_pieces_and_a_tablet() {
  TriangleMesh mesh = separate_pieces();
  TriangleMesh tablet = generate_scan({.kind = "tablet", .vertices = 20000}).value();
  const double scale = 28 / compute_statistics(tablet).diagonal();
  for (Vec3d& vertex : tablet.vertices) vertex *= scale;
  append(tablet, Vec3d(0, 0, 30), mesh);
  return mesh;
}

}  // namespace burnish
