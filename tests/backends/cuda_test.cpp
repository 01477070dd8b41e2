// Facts about the CUDA backend itself, with a device and without.

#include <algorithm>
#include <limits>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "server/fields/fields.h"
#include "server/prepare/prepare.h"
#include "server/solver/cuda/cuda_backend.h"
#include "server/solver/tuning/plan_cycle.h"
#include "tests/backends/fault.h"
#include "tests/backends/filtered.h"
#include "tests/backends/on_a_device.h"
#include "tests/reference/awkward_meshes.h"

namespace burnish {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

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

TEST_F(OnADevice, AutoTakesItAndNamesIt) {
  const auto solver = open_solver({}).value();
  EXPECT_EQ(solver->backend_name(), "cuda");
  EXPECT_EQ(solver->backend_reason(), cuda_device().value());
}

TEST_F(OnADevice, ASmootherThatCudaHasNotIsRefusedByNameAndAutoTakesTheCpu) {
  for (const auto& [smoother, name, what] : kSmoothers) {
    SCOPED_TRACE(name);
    const auto on_cuda = open_solver({.backend = BackendKind::kCuda, .smoother = smoother});
    const auto on_either = open_solver({.smoother = smoother}).value();
    if (std::ranges::count(kCudaSmoothers, smoother) > 0) {
      EXPECT_TRUE(on_cuda.is_ok());
      EXPECT_EQ(on_either->backend_name(), "cuda");
      continue;
    }
    const std::string refusal =
        "smoother " + std::string(name) + ": the CUDA backend has schwarz and gauss-seidel only";
    ASSERT_FALSE(on_cuda.is_ok());
    EXPECT_EQ(on_cuda.status().code(), StatusCode::kUnimplemented);
    EXPECT_EQ(on_cuda.status().message(), "backend cuda: " + refusal);
    EXPECT_EQ(on_either->backend_name(), "cpu");
    EXPECT_EQ(on_either->backend_reason(), refusal);
  }
}

TEST_F(OnADevice, TwoRunsGiveTheSameBits) {
  const TriangleMesh mesh = generate_scan({.kind = "blob", .vertices = 20000}).value();
  const auto run = [&](Smoother smoother) {
    Filtered filtered(mesh, 7, {.backend = BackendKind::kCuda, .smoother = smoother});
    auto& edited = filtered.alpha(20).beta(0.3);
    edited.after(3);
    return edited.alpha(30).after(4);
  };
  for (const Smoother smoother : kCudaSmoothers)
    EXPECT_EQ(run(smoother), run(smoother)) << name_of(smoother);
}

constexpr int kDepthWithWeakParts = 5;  // the small components' depth

TEST_F(OnADevice, TwoRunsWithSheetsApartGiveTheSameBits) {
  const TriangleMesh mesh = reference::small_components_over_a_sphere();
  const auto run = [&](int depth) {
    Filtered filtered(mesh, depth, {.backend = BackendKind::kCuda});
    auto& edited = filtered.alpha(20).beta(0.3);
    edited.after(3);
    edited.paint({{.radius = 0.3, .strength = 0.7, .beta = 2}, {mesh.vertices[7]}}).after(1);
    return edited.alpha(30).after(4);
  };
  for (const int depth : {kDepthWithWeakParts, 6}) EXPECT_EQ(run(depth), run(depth)) << depth;
}

TEST_F(OnADevice, BetaOneGivesTheInputBack) {
  const TriangleMesh mesh = generate_scan({.kind = "blob", .vertices = 5000}).value();
  Filtered filtered(mesh, 6, {.backend = BackendKind::kCuda});
  EXPECT_EQ(filtered.alpha(20).after(20), mesh.vertices);
}

// Returns the largest distance between the two over the diagonal, cycle by cycle, so that neither
// hides behind the other's convergence. After one cycle both are 4e-2 off the solution.
double between_cpu_and_cuda(const TriangleMesh& mesh, Smoother smoother, int cycles) {
  const auto after = [&](BackendKind backend) {
    Filtered filtered(mesh, 7, {.backend = backend, .smoother = smoother});
    return filtered.curve(TransferCurve::parse("-20:5,20:500").value()).beta(0).after(cycles);
  };
  return largest_distance(after(BackendKind::kCpu), after(BackendKind::kCuda), mesh);
}

// They differ by rounding. Schwarz also differs by the start of the estimate of λmax. Except at
// weak parts, the finest depth's blocks also have another regularisation.
TEST_F(OnADevice, FollowsTheCpuCycleByCycle) {
  std::map<std::string, TriangleMesh> meshes = {
      {"crossing spheres", crossing_spheres()},
      {"small components", reference::small_components_over_a_sphere()}};
  for (const char* kind : {"tablet", "sheets", "blob"})
    meshes[kind] = generate_scan({.kind = kind, .vertices = 20000}).value();
  for (const auto& [name, mesh] : meshes)
    for (const int cycles : {1, 2, 5}) {
      SCOPED_TRACE(name + " after " + std::to_string(cycles) + " cycles");
      EXPECT_LE(between_cpu_and_cuda(mesh, Smoother::kSchwarz, cycles), 3e-4);
      EXPECT_LE(between_cpu_and_cuda(mesh, Smoother::kGaussSeidel, cycles), 2e-5);
    }
}

TriangleMesh torn_wall() {
  return generate_scan({.kind = "wall", .vertices = 10'000}).value();
}

// Its coarse depths have ties, and its small components follow it there.
TEST_F(OnADevice, ATornWallEndsWhereTheCpuDoes) {
  const TriangleMesh mesh = torn_wall();
  const auto edited = [&](BackendKind backend) {
    Filtered filtered(mesh, 6, {.backend = backend});
    filtered.curve(TransferCurve::parse("-20:5,20:500").value()).beta(0).after(2);
    return filtered.alpha(5).exact();
  };
  EXPECT_LE(largest_distance(edited(BackendKind::kCpu), edited(BackendKind::kCuda), mesh), 1e-5);
}

TEST(SheetsApart, OfATornWallHaveAllThatSlotsCannotSay) {
  const auto prepared = prepare(torn_wall(), {.depth = 6}).value();
  const auto hierarchy = make_hierarchy(*prepared);
  const HierarchyDepth &finest = hierarchy->at(6), &coarse = hierarchy->at(5);
  EXPECT_EQ(finest.stencil.irregular.count(), 0);
  EXPECT_GT(finest.to_parent.shared.count(), 0);
  EXPECT_GT(coarse.stencil.irregular.count(), 0);
  EXPECT_GT(coarse.stencil.irregular_cells.count(), 0);
  EXPECT_FALSE(coarse.ties.empty());
  EXPECT_FALSE(coarse.shares.apart.empty());
  EXPECT_GT(hierarchy->depths.front().stencil.irregular.count(), 0);
  EXPECT_FALSE(hierarchy->depths.front().ties.empty());
}

TEST(SheetsApart, OfSmallComponentsHaveWeakPartsAtOneDepth) {
  for (const int depth : {kDepthWithWeakParts, 6}) {
    const auto prepared =
        prepare(reference::small_components_over_a_sphere(), {.depth = depth}).value();
    EXPECT_EQ(make_multigrid(prepared).value().plan->has_weak_parts(depth),
              depth == kDepthWithWeakParts);
  }
}

// The constraint continues from its last value, so an error in it would stay.
TEST_F(OnADevice, EditAfterEditEndsWhereTheCpuDoes) {
  const TriangleMesh mesh = generate_scan({.kind = "blob", .vertices = 8000}).value();
  const auto edited = [&](BackendKind backend) {
    Filtered filtered(mesh, 6, {.backend = backend});
    const auto dab = [&](size_t vertex, double beta) {
      return Stroke{{.radius = 0.3, .strength = 0.7, .beta = beta}, {mesh.vertices[vertex]}};
    };
    filtered.alpha(20).beta(0.3).after(1);
    filtered.beta(0.6).after(1);
    filtered.paint(dab(7, 2)).after(1);
    EXPECT_TRUE(filtered.session().apply({"undo", Undo{}}).is_ok());  // one β for all cells again
    filtered.after(1);
    filtered.beta(0.4).after(1);
    filtered.paint(dab(7, 2)).after(1);
    filtered.beta(1.5).after(1);
    filtered.curve(TransferCurve::parse("-20:5,20:500").value()).after(1);
    filtered.alpha(40).paint(dab(4000, 0)).after(1);
    for (const double alpha : {45, 50, 30}) filtered.alpha(alpha).after(1);  // the same ratios
    filtered.curve(TransferCurve::parse("-20:5,20:500").value()).after(1);
    filtered.alpha(35).beta(0.9).after(1);
    filtered.paint(dab(7999, 1)).beta(0.5).after(1);
    Stroke all = dab(100, 1.5);
    all.brush.radius = 10;
    filtered.paint(all).after(1);
    filtered.beta(0.7).after(1);
    return filtered.exact();
  };
  EXPECT_LE(largest_distance(edited(BackendKind::kCpu), edited(BackendKind::kCuda), mesh), 2e-6);
}

// The device computes α of the cells: from a curve of several points and for cells with their own
// α, over two edits.
TEST_F(OnADevice, CellsOfTheirOwnAndACurveOfManyPointsEndWhereTheCpuDoes) {
  const TriangleMesh mesh = generate_scan({.kind = "blob", .vertices = 8000}).value();
  const auto edited = [&](int depth, BackendKind backend) {
    Filtered filtered(mesh, depth, {.backend = backend});
    filtered.curve(TransferCurve::parse("-20:5,-2:40,0:8,1:60,25:500").value()).beta(0).after(1);
    const std::span<const MortonKey> cells = filtered.session().prepared().cells;
    for (const double alpha : {3.0, 200.0}) {
      SetCellFields own;
      for (size_t c = 0; c < cells.size(); c += alpha == 3 ? 7 : 5)
        own.cells.push_back({morton_point(cells[c]), alpha, 2 * alpha, 0.5});
      EXPECT_TRUE(filtered.session().apply({"own", own}).is_ok());
      filtered.after(1);
    }
    return filtered.exact();
  };
  for (const int depth : {4, 6})
    EXPECT_LE(
        largest_distance(edited(depth, BackendKind::kCpu), edited(depth, BackendKind::kCuda), mesh),
        2e-6)
        << depth;
}

double between_cpu_and_cuda_settled(const TriangleMesh& mesh, int depth) {
  const auto settled = [&](BackendKind backend) {
    Filtered filtered(mesh, depth, {.backend = backend});
    return filtered.alpha(5).beta(0.5).exact();
  };
  return largest_distance(settled(BackendKind::kCpu), settled(BackendKind::kCuda), mesh);
}

// Its rim has corners with very little surface. The rounding of floats in the constraint's shares
// would move a vertex there by 1.2e-4 of the diagonal.
TEST_F(OnADevice, AtAContrastOf1000ATornRimEndsWhereTheCpuDoes) {
  const TriangleMesh mesh = generate_scan({.kind = "tablet", .vertices = 20000}).value();
  const auto settled = [&](BackendKind backend) {
    Filtered filtered(mesh, 7, {.backend = backend});
    return filtered.curve(TransferCurve::parse("-20:1,20:1000").value()).beta(0).exact();
  };
  EXPECT_LE(largest_distance(settled(BackendKind::kCpu), settled(BackendKind::kCuda), mesh), 1e-5);
}

// Flat faces have moves without energy, which rounded entries of S would take for less than none.
TEST_F(OnADevice, AtASmallAlphaFlatPiecesEndWhereTheCpuDoes) {
  for (const char* kind : {"part", "sheet"}) {
    const TriangleMesh mesh = generate_scan({.kind = kind, .vertices = 20000}).value();
    const auto settled = [&](BackendKind backend) {
      Filtered filtered(mesh, 6, {.backend = backend});
      return filtered.alpha(0.05).beta(2).exact();
    };
    EXPECT_LE(largest_distance(settled(BackendKind::kCpu), settled(BackendKind::kCuda), mesh), 1e-5)
        << kind;
  }
}

// Hundreds of separate pieces keep hundreds of coarsest corners, which the host solves directly.
TEST_F(OnADevice, ManySeparatePiecesSettle) {
  EXPECT_LE(between_cpu_and_cuda_settled(separate_pieces(), 6), 2e-5);
  EXPECT_LE(between_cpu_and_cuda_settled(separate_pieces_and_a_tablet(), kDepthOfPieces), 2e-5);
}

TEST(SheetsApart, OfCrossingSpheresAreThoseOfComponents) {
  const auto prepared = prepare(crossing_spheres(), {.depth = 7}).value();
  const auto hierarchy = make_hierarchy(*prepared);
  EXPECT_GT(hierarchy->at(7).sheet_count, 0);
  EXPECT_FALSE(hierarchy->at(6).shares.share.empty());
}

TEST(SheetsApart, OfManyPiecesReachTheHostsDirectSolve) {
  const auto prepared = prepare(separate_pieces_and_a_tablet(), {.depth = kDepthOfPieces}).value();
  const auto hierarchy = make_hierarchy(*prepared);
  const HierarchyDepth& coarsest = hierarchy->depths.front();
  EXPECT_GT(coarsest.grid.corner_count(), 4096);
  EXPECT_GT(coarsest.stencil.irregular.count(), 0);
}

TEST_F(OnADevice, WhatIsReadOutIsWhatTheCpuHas) {
  const TriangleMesh mesh = generate_scan({.kind = "blob", .vertices = 5000}).value();
  Filtered on_cpu(mesh, 6, {.backend = BackendKind::kCpu});
  Filtered on_cuda(mesh, 6, {.backend = BackendKind::kCuda});
  on_cpu.alpha(20).beta(0).exact();
  on_cuda.alpha(20).beta(0).exact();
  const Solver &one = on_cpu.session().solver(), &other = on_cuda.session().solver();
  const auto farthest = [](std::span<const Vec3f> a, std::span<const Vec3f> b) {
    float most = 0;
    for (size_t i = 0; i < a.size(); ++i) {
      EXPECT_TRUE(a[i].allFinite() && b[i].allFinite()) << i;
      most = std::max(most, (a[i] - b[i]).norm());
    }
    return most;
  };
  ASSERT_EQ(one.displacement().size(), other.displacement().size());
  ASSERT_EQ(one.vertex_displacement().size(), mesh.vertices.size());
  ASSERT_EQ(other.vertex_displacement().size(), mesh.vertices.size());
  EXPECT_LE(farthest(one.vertex_displacement(), other.vertex_displacement()), 1e-4f);  // cells
}

TEST_F(OnADevice, TwoSessionsAreOnAsManyDevicesAsThereAre) {
  const auto one = open_solver({.backend = BackendKind::kCuda}).value();
  const auto other = open_solver({.backend = BackendKind::kCuda}).value();
  const std::vector<uint64_t> bytes = cuda_memory_by_device();
  const auto in_use = std::ranges::count_if(bytes, [](uint64_t b) { return b > 0; });
  EXPECT_EQ(in_use, std::min<int64_t>(2, std::ssize(bytes)));
  Fields fields(*small_scan());
  fields.set_gradient_scale(0);
  for (Solver* solver : {one.get(), other.get()}) {
    solver->set_metric(fields.view());
    EXPECT_TRUE(solver->solve(1e-6, 50).value().converged);
  }
  EXPECT_LE((one->displacement()[0] - other->displacement()[0]).norm(), 1e-4f);
}

TEST_F(OnADevice, BeyondTheBudgetIsRefusedWithNumbersAndGivesAllBack) {
  const uint64_t before = cuda_memory_used();
  set_cuda_memory_budget(before + 1'000'000);
  const auto refused = open_solver({.backend = BackendKind::kCuda});
  set_cuda_memory_budget(std::numeric_limits<uint64_t>::max());
  ASSERT_FALSE(refused.is_ok());
  EXPECT_EQ(refused.status().code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(refused.status().message(), HasSubstr("bytes on the device: it uses "));
  EXPECT_EQ(cuda_memory_used(), before);
  EXPECT_TRUE(open_solver({.backend = BackendKind::kCuda}).is_ok());
}

// Runs in its own process: after the fault that has no device.
TEST_F(OnADevice, AFaultSticksToSolverAndProbe) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const auto live_on = [] {
    const auto solver = open_solver({.backend = BackendKind::kCuda}).value();
    const auto prepared = small_scan();
    const Fields fields(*prepared);
    solver->set_metric(fields.view());
    const bool was_well = probe_cuda_device().is_ok();
    provoke_cuda_fault();
    const auto solved = solver->solve(1e-4, 5);
    const bool told = solved.status().code() == StatusCode::kInternal &&
                      solver->status().code() == StatusCode::kInternal &&
                      probe_cuda_device().code() == StatusCode::kInternal;
    std::fprintf(stderr, "%s\n", solved.status().message().c_str());
    std::_Exit(was_well && told ? 0 : 1);
  };
  EXPECT_EXIT(live_on(), testing::ExitedWithCode(0), "CUDA: ");
}

}  // namespace
}  // namespace burnish
