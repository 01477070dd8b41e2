#include "server/solver/solver.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "server/solver/cpu/cpu_backend.h"
#include "server/solver/cycle/vcycle.h"
#include "tests/reference/awkward_meshes.h"
#include "tests/reference/compare.h"
#include "tests/reference/reference.h"
#include "tests/reference/shapes.h"
#include "tests/server/solver/test_system.h"

namespace burnish {
namespace {

std::unique_ptr<Solver> solver_of(const TestSystem& system, Smoother smoother = Smoother::kSchwarz,
                                  int threads = 1) {
  SolverOptions options;
  options.backend = BackendKind::kCpu;
  options.smoother = smoother;
  options.threads = threads;
  auto solver = std::move(Solver::create(system, options)).value();
  solver->set_metric(system.fields.view());
  return solver;
}

TEST(Solver, ReturnsTheInputBitExactlyWhereBetaIsOne) {
  const TriangleMesh mesh = reference::bumpy_sphere(2);
  TestSystem system(mesh, 4);
  system.fields.set_transfer_curve(test_curve(100));
  for (const auto& [smoother, name, what] : kSmoothers) {
    SCOPED_TRACE(name);
    const auto solver = solver_of(system, smoother);
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(solver->step().energy, 0);
    EXPECT_EQ(solver->evaluate_vertices(), mesh.vertices);
  }
}

TEST(Solver, AfterFallingBackTheBackendReachesTheSameSurface) {
  TestSystem system(reference::bumpy_sphere(3), 5);
  system.fields.set_gradient_scale(0);
  const auto usual = solver_of(system);
  ASSERT_TRUE(usual->solve(1e-7, 200).value().converged);
  const FieldsView fields = system.fields.view();
  const auto backend = make_cpu_backend(system, Smoother::kSchwarz);
  backend->set_metric(fields.metric);
  backend->set_constraint(fields);
  backend->fall_back();
  backend->recompute_residual();
  for (int i = 0; i < 100; ++i) {
    run_vcycle(*backend, system, system.hierarchy->finest);
    backend->update_direction(i == 0);
    backend->advance();
  }
  const std::span<const Vec3f> fallen = backend->vertex_displacement();
  double most = 0;
  for (size_t v = 0; v < fallen.size(); ++v)
    most = std::max<double>(most, (fallen[v] - usual->vertex_displacement()[v]).norm());
  EXPECT_LT(most, 1e-4);  // cells
}

TEST(Solver, ASystemThatIsNotFiniteIsSaidAndTheNextOneIsSolved) {
  TestSystem system(reference::bumpy_sphere(2), 4);
  system.fields.set_gradient_scale(0);
  SolverOptions options;
  options.backend = BackendKind::kCpu;
  const auto solver = std::move(Solver::create(system, options)).value();
  const size_t corners = system.hierarchy->depths.back().grid.corners.size();
  solver->set_signal(std::vector<Vec3f>(corners, Vec3f(1, NAN, 1)));
  solver->set_metric(system.fields.view());
  const StepReport failed = solver->step();
  EXPECT_TRUE(failed.fell_back);
  EXPECT_GE(failed.distance, 1);
  EXPECT_FALSE(solver->soundness().is_ok());
  EXPECT_FALSE(solver->solve(1e-5, 10).is_ok());
  for (const Vec3f& u : solver->displacement()) ASSERT_EQ(u, Vec3f::Zero());

  std::vector<Vec3f> signal(corners, Vec3f::Zero());
  for (size_t i = 0; i < corners; i += 2) signal[i].x() = 1;
  solver->set_signal(signal);
  solver->set_metric(system.fields.view());
  EXPECT_TRUE(solver->soundness().is_ok());
  EXPECT_FALSE(solver->step().fell_back);
  EXPECT_TRUE(solver->solve(1e-4, 100).value().converged);
}

TEST(Solver, EnergyNeverRises) {
  for (const auto& [mesh_name, mesh] : reference::awkward_meshes()) {
    TestSystem system(mesh, 5);
    system.fields.set_gradient_scale(0);
    system.fields.set_transfer_curve(test_curve(100));
    for (const auto& [smoother, name, what] : kSmoothers) {
      SCOPED_TRACE(mesh_name + ", " + std::string(name));
      const auto solver = solver_of(system, smoother);
      double last = 0;
      for (int i = 0; i < 50; ++i) {
        const double energy = solver->step().energy;
        ASSERT_LE(energy, last + 1e-12 * std::abs(last)) << "step " << i + 1;
        last = energy;
      }
      EXPECT_LT(last, 0);
    }
  }
}

// If one term of S is a million times the other, float32 tables alone would not be definite.
TEST(Solver, IsStableAtTheLimitsOfAlphaAndContrast) {
  const TransferCurve curves[] = {TransferCurve(kAlphaMin), TransferCurve(1e3), TransferCurve(1e4),
                                  TransferCurve(kAlphaMax), test_curve(kCurveContrastMax)};
  for (const auto& [name, mesh] : reference::awkward_meshes()) {
    TestSystem system(mesh, 4);
    system.fields.set_gradient_scale(0);
    for (const TransferCurve& curve : curves) {
      SCOPED_TRACE(name + ", alpha " + curve.to_string());
      system.fields.set_transfer_curve(curve);
      const auto solver = solver_of(system);
      double last = 0;
      for (int i = 0; i < 20; ++i) {
        const double energy = solver->step().energy;
        ASSERT_LE(energy, last + 1e-12 * std::abs(last)) << "step " << i + 1;
        last = energy;
      }
      const auto moved = reference::vertex_distance(solver->evaluate_vertices(), mesh.vertices,
                                                    reference::box_diagonal(mesh));
      EXPECT_LT(moved.max, 1);
    }
  }
}

TEST(Solver, HoldsTheSurfaceAsTheReferenceDoesWhereAlphaIsVeryLarge) {
  for (const TriangleMesh& mesh : {reference::needles(), reference::bumpy_sphere(4)}) {
    TestSystem system(mesh, 5);
    system.fields.set_gradient_scale(0);
    const reference::System expected_system = reference::build(mesh, 5);
    for (double alpha : {3e2, 1e3, 1e4, 1e5}) {
      system.fields.set_transfer_curve(TransferCurve(alpha));
      const auto solver = solver_of(system);
      ASSERT_TRUE(solver->solve(1e-8, 60).is_ok());
      const auto expected = reference::edited_vertices(
          expected_system, reference::fields(expected_system, TransferCurve(alpha), 0));
      const auto distance = reference::vertex_distance(solver->evaluate_vertices(), expected,
                                                       reference::box_diagonal(mesh));
      EXPECT_LT(distance.max, 1e-4) << "alpha " << alpha;
      EXPECT_LT(distance.rms, 1e-5) << "alpha " << alpha;
    }
  }
}

// Small steps of α do not estimate the largest eigenvalue each time.
TEST(Solver, AfterADragOfAlphaConvergesAsAFreshOne) {
  TestSystem system(reference::bumpy_sphere(5), 6);
  system.fields.set_gradient_scale(0);
  system.fields.set_transfer_curve(TransferCurve(1));
  const auto dragged = solver_of(system, Smoother::kSchwarz, 1);
  for (double alpha = 1; alpha < 900; alpha *= 1.2) {
    system.fields.set_transfer_curve(TransferCurve(alpha));
    dragged->set_metric(system.fields.view());
    dragged->step();
  }
  system.fields.set_transfer_curve(TransferCurve(1000));
  dragged->set_metric(system.fields.view());
  const auto fresh = solver_of(system, Smoother::kSchwarz, 1);
  const SolveReport after_drag = dragged->solve(1e-8, 100).value();
  const SolveReport from_cold = fresh->solve(1e-8, 100).value();
  EXPECT_TRUE(after_drag.converged);
  EXPECT_LE(after_drag.cycles, from_cold.cycles + 1);
}

/// All calls of a session to a solver, and every number that it returns.
struct Life {
  std::vector<double> numbers;
  std::vector<Vec3d> vertices;
  bool operator==(const Life&) const = default;
};

Life live(TestSystem& system, Smoother smoother, int threads) {
  Life life;
  const auto note = [&](const StepReport& r) {
    life.numbers.insert(life.numbers.end(), {r.energy, r.residual, r.distance});
  };
  system.fields.set_gradient_scale(0.2);
  system.fields.set_transfer_curve(test_curve(30));
  const auto solver = solver_of(system, smoother, threads);
  for (int i = 0; i < 3; ++i) note(solver->step());
  system.fields.set_gradient_scale(1.7);
  solver->set_gradient_scale(system.fields.view());
  for (int i = 0; i < 2; ++i) note(solver->step());
  system.fields.set_transfer_curve(test_curve(50));
  solver->set_metric(system.fields.view());
  const SolveReport exact = solver->solve(1e-7, 30).value();
  note(exact.last);
  life.numbers.push_back(exact.cycles);
  life.vertices = solver->evaluate_vertices();
  return life;
}

TEST(Solver, GivesTheSameBitsForAnyNumberOfThreadsAndAgain) {
  TestSystem system(reference::several_components(), 5);
  for (const auto& [smoother, name, what] : kSmoothers) {
    SCOPED_TRACE(name);
    const Life one = live(system, smoother, 1);
    for (int threads : {1, 2, 3}) EXPECT_EQ(live(system, smoother, threads), one) << threads;
  }
}

TEST(Solver, KeepsPinnedCornersInPlace) {
  TestSystem system(reference::bumpy_sphere(4), 6);
  system.fields.set_gradient_scale(0);
  const auto depths = system.assembled();
  const auto backend = make_cpu_backend(system, Smoother::kSchwarz);
  const FieldsView view = system.fields.view();
  backend->set_metric(view.metric);
  backend->set_constraint(view);
  backend->recompute_residual();
  for (int i = 0; i < 5; ++i) {
    run_vcycle(*backend, system, system.hierarchy->finest);
    backend->update_direction(i == 0);
    backend->advance();
  }
  const auto displacement = backend->displacement();
  int pinned = 0, moved = 0;
  for (int32_t i = 0; i < depths.back().corner_count(); ++i) {
    if (depths.back().inverse_diagonal[i] != 0) {
      moved += displacement[i] != Vec3f::Zero();
      continue;
    }
    ++pinned;
    ASSERT_EQ(displacement[i], Vec3f::Zero()) << "corner " << i;
  }
  EXPECT_GT(pinned, 0);
  EXPECT_GT(moved, 1000);
}

TEST(Solver, TheCycleStartsFromTheResidualThatAConstraintLeft) {
  TestSystem system(reference::bumpy_sphere(3), 5);
  const auto backend = make_cpu_backend(system, Smoother::kSchwarz);
  backend->set_metric(system.fields.view().metric);
  backend->set_constraint(system.fields.view());
  backend->recompute_residual();
  system.fields.set_gradient_scale(0);
  backend->set_constraint(system.fields.view());
  const auto step = [&] {
    run_vcycle(*backend, system, system.hierarchy->finest);
    backend->update_direction(true);
    backend->advance();
    return backend->measure();
  };
  const Measures first = step(), second = step();
  EXPECT_LT(first.energy, 0);
  EXPECT_LT(second.energy, first.energy);
  EXPECT_LT(second.preconditioned_residual, 0.1 * first.preconditioned_residual);
}

TEST(Solver, ConvergesToTheSameSurfaceFromAnyStart) {
  const TriangleMesh mesh = reference::bumpy_sphere(4);
  TestSystem system(mesh, 6);
  system.fields.set_gradient_scale(0);
  const auto cold = solver_of(system);
  ASSERT_TRUE(cold->solve(1e-7, 100)->converged);

  system.fields.set_gradient_scale(3);
  system.fields.set_transfer_curve(test_curve(100));
  const auto warm = solver_of(system, Smoother::kGaussSeidel);
  ASSERT_TRUE(warm->solve(1e-4, 100).is_ok());
  system.fields.set_transfer_curve(TransferCurve(50));
  warm->set_metric(system.fields.view());
  system.fields.set_gradient_scale(0);
  warm->set_gradient_scale(system.fields.view());
  ASSERT_TRUE(warm->solve(1e-7, 200)->converged);

  const auto distance = reference::vertex_distance(
      cold->evaluate_vertices(), warm->evaluate_vertices(), reference::box_diagonal(mesh));
  EXPECT_LT(distance.max, 2e-6);
  EXPECT_GT(reference::vertex_distance(cold->evaluate_vertices(), mesh.vertices,
                                       reference::box_diagonal(mesh))
                .max,
            1e-3);
}

// Returns the largest distance of any vertex from `converged` after some steps, over the box's
// diagonal.
double distance_after(int steps, const TestSystem& system, const std::vector<Vec3d>& converged) {
  const auto solver = solver_of(system);
  for (int i = 0; i < steps; ++i) solver->step();
  const std::vector<Vec3d> now = solver->evaluate_vertices();
  double distance = 0;
  for (size_t v = 0; v < now.size(); ++v)
    distance = std::max(distance, (now[v] - converged[v]).norm());
  return distance / system.prepared->statistics.diagonal();
}

// A V-cycle leaves six times as much.
TEST(Solver, ANewMetricIsNearItsEndAfterOneStep) {
  const TriangleMesh mesh = generate_scan({.kind = "blob", .vertices = 20000}).value();
  TestSystem system(mesh, 7);
  system.fields.set_gradient_scale(0);
  system.fields.set_transfer_curve(TransferCurve(5));
  const auto solver = solver_of(system);
  ASSERT_TRUE(solver->solve(1e-8, 100)->converged);
  system.fields.set_transfer_curve(TransferCurve(6.25));
  solver->set_metric(system.fields.view());
  solver->step();
  const std::vector<Vec3d> after_one = solver->evaluate_vertices();
  ASSERT_TRUE(solver->solve(1e-8, 100)->converged);
  const auto distance = reference::vertex_distance(after_one, solver->evaluate_vertices(),
                                                   reference::box_diagonal(mesh));
  EXPECT_LT(distance.max, 1e-4);
}

TEST(Solver, SmallComponentsConvergeFasterWhenTheyAreKeptApart) {
  TestSystem system(reference::small_components_over_a_sphere(), 5);
  system.fields.set_transfer_curve(TransferCurve(2));
  system.fields.set_gradient_scale(0);
  TestSystem together = system;
  together.hierarchy = make_hierarchy(*system.prepared, Sheets::kTogether);
  together.plan = std::make_shared<CyclePlan>();
  const auto solver = solver_of(system);
  for (int i = 0; i < 200; ++i) solver->step();
  const std::vector<Vec3d> converged = solver->evaluate_vertices();
  EXPECT_LT(distance_after(10, system, converged), 0.01 * distance_after(10, together, converged));
}

// Without their patches they are seven times as far off.
TEST(Solver, SmallComponentsThatHangOnASurfaceFollowItInThreeSteps) {
  TestSystem system(reference::small_components_over_a_sphere(), 6);
  system.fields.set_transfer_curve(TransferCurve(5));
  system.fields.set_gradient_scale(0);
  const auto solver = solver_of(system);
  for (int i = 0; i < 200; ++i) solver->step();
  EXPECT_LT(distance_after(3, system, solver->evaluate_vertices()), 1e-4);
}

// Without patches they are twenty times as far off.
TEST(Solver, SpikesSettleInTenStepsAsTheRest) {
  TestSystem system(reference::spiked_sphere(), 6);
  system.fields.set_gradient_scale(0);
  const auto solver = solver_of(system);
  for (int i = 0; i < 200; ++i) solver->step();
  EXPECT_LT(distance_after(10, system, solver->evaluate_vertices()), 1e-6);
}

// Corners of triangles hang across a plane there. If settling after eight steps is the trial's only
// milestone, the rim is twelve times as far off.
TEST(Solver, ATornRimIsSettledAfterFiveSteps) {
  TestSystem system(generate_scan({.kind = "tablet", .vertices = 5000}).value(), 6);
  system.fields.set_gradient_scale(0);
  const auto solver = solver_of(system);
  for (int i = 0; i < 100; ++i) solver->step();
  EXPECT_LT(distance_after(5, system, solver->evaluate_vertices()), 2e-5);
}

TEST(Solver, ShardsThatHangByASliverConvergeAsTheRest) {
  TestSystem system(reference::shards_over_a_sphere(), 5);
  system.fields.set_transfer_curve(TransferCurve(5));
  system.fields.set_gradient_scale(0);
  const auto solver = solver_of(system);
  for (int i = 0; i < 200; ++i) solver->step();
  EXPECT_LT(distance_after(20, system, solver->evaluate_vertices()), 1e-6);
}

TEST(Solver, StopsWhereItsProgressSaysSo) {
  TestSystem system(make_icosphere(3, 1), 5);
  system.fields.set_gradient_scale(0);
  const auto solver = solver_of(system);
  int reports = 0;
  const auto result = solver->solve(0, 100, [&](auto, auto) { return ++reports <= 3; });
  ASSERT_FALSE(result.is_ok());
  EXPECT_EQ(result.status().code(), StatusCode::kCancelled);
  EXPECT_THAT(result.status().message(), testing::HasSubstr("after 3 cycles"));
  EXPECT_EQ(solver->step().cycle, 4);
}

TEST(Solver, TakesMeshesThatNeedNoHierarchy) {
  const TriangleMesh triangle = {{{0, 0, 0}, {1, 0, 0}, {0.3, 1, 0.2}}, {{0, 1, 2}}};
  TestSystem system(triangle, 4);
  ASSERT_EQ(system.hierarchy->coarsest, system.hierarchy->finest);
  system.fields.set_gradient_scale(0.5);
  const auto solver = solver_of(system);
  ASSERT_TRUE(solver->solve(1e-8, 50)->converged);
  for (const Vec3d& p : solver->evaluate_vertices()) EXPECT_TRUE(p.allFinite());
}

}  // namespace
}  // namespace burnish
