// What the CUDA backend says of itself, with a device and without.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/mesh/generate.h"
#include "server/prepare/prepare.h"
#include "server/solver/cuda/cuda_backend.h"
#include "tests/backends/filtered.h"

namespace burnish {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

std::shared_ptr<const PreparedMesh> small_scan() {
  return prepare(generate_scan({.kind = "icosphere", .vertices = 600}).value(), {.depth = 5})
      .value();
}

Result<std::unique_ptr<Solver>> open_solver(const SolverOptions& options) {
  const auto prepared = small_scan();
  return Solver::create(prepared, make_hierarchy(*prepared), options);
}

TEST(CudaBackend, WithoutADeviceTheErrorSaysWhatIsMissing) {
  if (cuda_device().is_ok()) GTEST_SKIP() << "there is a device: " << cuda_device().value();
  const auto solver = open_solver({.backend = BackendKind::kCuda});
  ASSERT_FALSE(solver.is_ok());
  EXPECT_EQ(solver.status().code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(solver.status().message(),
              AnyOf(HasSubstr("no CUDA device: "), HasSubstr("this build has no CUDA backend")));
}

TEST(CudaBackend, WithoutADeviceAutoTakesTheCpuAndSaysWhy) {
  if (cuda_device().is_ok()) GTEST_SKIP() << "there is a device: " << cuda_device().value();
  const auto solver = open_solver({.backend = BackendKind::kAuto}).value();
  EXPECT_EQ(solver->backend_name(), "cpu");
  EXPECT_EQ(solver->backend_reason(), cuda_device().status().message());
}

class OnADevice : public testing::Test {
 protected:
  void SetUp() override {
    const auto device = cuda_device();
    if (!device.is_ok()) GTEST_SKIP() << device.status().message();
  }
};

TEST_F(OnADevice, AutoTakesItAndNamesIt) {
  const auto solver = open_solver({}).value();
  EXPECT_EQ(solver->backend_name(), "cuda");
  EXPECT_EQ(solver->backend_reason(), cuda_device().value());
}

TEST_F(OnADevice, AutoTakesTheCpuForASmootherThatCudaHasNot) {
  const auto solver = open_solver({.smoother = Smoother::kGaussSeidel}).value();
  EXPECT_EQ(solver->backend_name(), "cpu");
  EXPECT_THAT(solver->backend_reason(),
              HasSubstr("smoother gauss-seidel: the CUDA backend has schwarz only"));
}

TEST_F(OnADevice, TwoRunsGiveTheSameBits) {
  const TriangleMesh mesh = generate_scan({.kind = "blob", .vertices = 20000}).value();
  const auto run = [&] {
    Filtered filtered(mesh, 7, {.backend = BackendKind::kCuda});
    auto& edited = filtered.alpha(20).beta(0.3);
    edited.after(3);
    return edited.alpha(30).after(4);
  };
  EXPECT_EQ(run(), run());
}

TEST_F(OnADevice, BetaOneGivesTheInputBack) {
  const TriangleMesh mesh = generate_scan({.kind = "blob", .vertices = 5000}).value();
  Filtered filtered(mesh, 6, {.backend = BackendKind::kCuda});
  EXPECT_EQ(filtered.alpha(20).after(20), mesh.vertices);
}

// Cycle by cycle, so that neither hides behind the other's convergence. They differ by rounding in
// the float32 cycle and by where the estimate of λmax starts; one cycle is 4e-2 off the solution.
TEST_F(OnADevice, FollowsTheCpuCycleByCycle) {
  const TriangleMesh mesh = generate_scan({.kind = "tablet", .vertices = 20000}).value();
  const auto curve = TransferCurve::parse("-20:5,20:500").value();
  const auto after = [&](BackendKind backend, int cycles) {
    Filtered filtered(mesh, 7, {.backend = backend});
    return filtered.curve(curve).beta(0).after(cycles);
  };
  const double diagonal = compute_statistics(mesh).diagonal();
  for (const int cycles : {1, 2, 5}) {
    const auto on_cpu = after(BackendKind::kCpu, cycles);
    const auto on_cuda = after(BackendKind::kCuda, cycles);
    double most = 0;
    for (size_t v = 0; v < on_cpu.size(); ++v)
      most = std::max(most, (on_cpu[v] - on_cuda[v]).norm());
    EXPECT_LE(most, 1e-3 * diagonal) << cycles << " cycles";
  }
}

// Hundreds of separate pieces keep hundreds of coarsest corners: the direct solve of the host.
TEST_F(OnADevice, ManySeparatePiecesSettle) {
  TriangleMesh mesh;
  const TriangleMesh piece = generate_scan({.kind = "icosphere", .vertices = 12}).value();
  for (int i = 0; i < 512; ++i) {
    const Vec3d at = 4 * Vec3d(i % 8, i / 8 % 8, i / 64);
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    for (const Vec3d& vertex : piece.vertices) mesh.vertices.push_back(vertex + at);
    for (const Triangle& t : piece.triangles)
      mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  const auto settled = [&](BackendKind backend) {
    Filtered filtered(mesh, 6, {.backend = backend});
    return filtered.alpha(5).beta(0.5).settled();
  };
  const auto on_cpu = settled(BackendKind::kCpu), on_cuda = settled(BackendKind::kCuda);
  const double diagonal = compute_statistics(mesh).diagonal();
  for (size_t v = 0; v < on_cpu.size(); ++v)
    ASSERT_LE((on_cpu[v] - on_cuda[v]).norm(), 2e-5 * diagonal) << "vertex " << v;
}

}  // namespace
}  // namespace burnish
