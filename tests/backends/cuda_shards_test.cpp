// Facts about a scan in shards on devices.

#include <limits>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "server/solver/cuda/cuda_backend.h"
#include "server/solver/multi/device_need.h"
#include "tests/backends/filtered.h"
#include "tests/backends/on_a_device.h"
#include "tests/reference/awkward_meshes.h"

namespace burnish {
namespace {

using testing::HasSubstr;

// Several shards on one device, and on all devices if there are several. Needs no second device.
SolverOptions in_shards(int count) {
  return {.backend = BackendKind::kCuda, .devices = count, .whole_corners_max = 500};
}

std::map<std::string, TriangleMesh> meshes_for_shards() {
  std::map<std::string, TriangleMesh> meshes = {
      {"crossing spheres", crossing_spheres()},
      {"small components", reference::small_components_over_a_sphere()},
      {"pieces", separate_pieces_and_a_tablet()}};
  meshes["tablet"] = generate_scan({.kind = "tablet", .vertices = 20000}).value();
  return meshes;
}

// Every call of a backend, over several edits. The third run of a kind of step replays a graph.
Filtered& edit_for_shards(Filtered& filtered, const TriangleMesh& mesh) {
  const double radius = 0.15 * filtered.diagonal();
  filtered.alpha(20).beta(0.3).after(3);
  filtered.beta(0.6).after(2);
  filtered.paint({{.radius = radius, .strength = 0.7, .beta = 2}, {mesh.vertices[7]}}).after(2);
  filtered.curve(TransferCurve::parse("-20:5,20:500").value()).after(3);
  for (const double alpha : {40, 45, 50}) filtered.alpha(alpha).after(2);
  filtered.paint({{.radius = radius, .strength = 1, .beta = 0}, {mesh.vertices[900]}}).after(1);
  return filtered.curve(TransferCurve::parse("-20:5,20:500").value());
}

TEST_F(OnADevice, InShardsEditAfterEditEndsWhereTheWholeDoes) {
  for (const auto& [name, mesh] : meshes_for_shards()) {
    const auto edited = [&](const SolverOptions& options) {
      Filtered filtered(mesh, 6, options);
      return edit_for_shards(filtered, mesh).exact();
    };
    const std::vector<Vec3d> whole = edited({.backend = BackendKind::kCuda, .devices = 1});
    for (const int shards : {2, 3, 4})
      EXPECT_LE(largest_distance(edited(in_shards(shards)), whole, mesh), 2e-6)
          << name << " in " << shards;
  }
}

TEST_F(OnADevice, InShardsTwoRunsGiveTheSameBits) {
  const TriangleMesh mesh = reference::small_components_over_a_sphere();
  for (const int shards : {2, 3, 4}) {
    const auto run = [&] {
      Filtered filtered(mesh, 6, in_shards(shards));
      return edit_for_shards(filtered, mesh).after(4);
    };
    EXPECT_EQ(run(), run()) << shards;
  }
}

TEST_F(OnADevice, InShardsBetaOneGivesTheInputBack) {
  const TriangleMesh mesh = generate_scan({.kind = "blob", .vertices = 5000}).value();
  Filtered filtered(mesh, 6, in_shards(2));
  EXPECT_EQ(filtered.alpha(20).after(20), mesh.vertices);
}

TEST_F(OnADevice, AScanBeyondOneDevicesMemoryGoesToAsManyAsHaveRoom) {
  const auto system = make_multigrid(small_scan()).value();
  const uint64_t one = predict_device_bytes(system);
  set_cuda_memory_budget(one / 2);
  const auto solver = Solver::create(system, {.backend = BackendKind::kCuda});
  set_cuda_memory_budget(std::numeric_limits<uint64_t>::max());
  const auto devices = static_cast<int>(cuda_memory_by_device().size());
  if (solver.is_ok()) {
    EXPECT_GT(devices, 1);
    EXPECT_THAT(solver.value()->backend_reason(), HasSubstr(" shards"));
  } else {
    EXPECT_EQ(solver.status().code(), StatusCode::kResourceExhausted);
  }
}

}  // namespace
}  // namespace burnish
