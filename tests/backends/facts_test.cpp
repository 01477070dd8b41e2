// Facts of any edit on any backend, from closed forms and symmetries (ARCHITECTURE.md,
// "Invariants").

#include <cmath>

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "common/mesh/srgb.h"
#include "common/mesh/statistics/statistics.h"
#include "server/prepare/prepare.h"
#include "server/solver/tuning/plan_cycle.h"
#include "tests/backends/filtered.h"
#include "tests/reference/compare.h"
#include "tests/reference/shapes.h"

namespace burnish {
namespace {

using reference::vertex_distance;

class Facts : public testing::TestWithParam<BackendCase> {
 protected:
  Filtered session(const TriangleMesh& mesh, int depth) {
    return Filtered(mesh, depth, GetParam().options);
  }
  std::vector<Vec3d> exact(const TriangleMesh& mesh, int depth, double alpha, double beta) {
    return session(mesh, depth).alpha(alpha).beta(beta).exact();
  }
};

// Facts that are cheap enough for each smoother.
class EverySmoother : public Facts {};

TriangleMesh bumpy() {
  return reference::bumpy_sphere(4);
}

TransferCurve contrast_100() {
  return TransferCurve::parse("-20:5,20:500").value();
}

TEST_P(EverySmoother, BetaOneReturnsTheInputMesh) {
  const TriangleMesh mesh = bumpy();
  Filtered filtered = session(mesh, 4);
  filtered.curve(contrast_100());
  EXPECT_EQ(filtered.after(1000), mesh.vertices);
}

// Frames on the way do not matter: a script's replay gives the same file.
TEST_P(Facts, ExactResultsFollowFromTheEditsAlone) {
  const TriangleMesh mesh = bumpy();
  const auto stroke = [&](const Filtered& on, size_t vertex) {
    return Stroke{{.radius = 0.15 * on.diagonal(), .strength = 0.8, .beta = 2},
                  {mesh.vertices[vertex]}};
  };
  Filtered live = session(mesh, 4), at_once = session(mesh, 4);
  live.alpha(8).beta(0.3).after(3);
  live.paint(stroke(live, 10)).after(2);
  live.beta(0.6).settled();
  live.curve(contrast_100()).after(4);
  live.paint(stroke(live, 500)).after(1);
  at_once.alpha(8).beta(0.3).paint(stroke(at_once, 10)).beta(0.6).curve(contrast_100());
  const std::vector<Vec3d> expected = at_once.paint(stroke(at_once, 500)).exact();
  EXPECT_EQ(live.exact(), expected);
  EXPECT_EQ(live.exact(), expected);
  live.after(2);
  EXPECT_EQ(live.exact(), expected);
}

// Sweeps from corner to corner creep along a stiff line: they do not reach the bar of exports.
TEST_P(Facts, HeldRimsMoveTheSurfaceAsOnTheProcessors) {
  if (GetParam().options.smoother != Smoother::kSchwarz) return;
  const TriangleMesh sheet = make_sheet(40, 1, 0.1);
  Filtered here = session(sheet, 5), there(sheet, 5, {.backend = BackendKind::kCpu});
  const auto exact = [](Filtered& on) {
    return on.controls({.pin_rims = true}).alpha(10).beta(0).exact();
  };
  const std::vector<Vec3d> moved = exact(here);
  EXPECT_LT(vertex_distance(moved, exact(there), here.diagonal()).max, 1e-6);
  EXPECT_GT(vertex_distance(moved, sheet.vertices, here.diagonal()).max, 1e-2);
  for (const uint32_t v : here.session().fields().rims()->vertices)
    EXPECT_EQ(moved[v], sheet.vertices[v]);
}

Protect half_of_it(const TriangleMesh& mesh) {
  const MeshStatistics statistics = compute_statistics(mesh);
  const Vec3d centre = (statistics.box_min + statistics.box_max) / 2;
  const double scale = 1 / statistics.diagonal();
  LassoRegion half;
  for (int axis = 0; axis < 3; ++axis) {
    half.view_projection[5 * axis] = scale;
    half.view_projection[4 * axis + 3] = -scale * centre[axis];
  }
  half.view_projection[15] = 1;
  half.polygon = {{-1, -1}, {0, -1}, {0, 1}, {-1, 1}};
  half.through = true;
  return {half};
}

// There mass outweighs stiffness, and coarse corners that the surface hardly reaches have next to
// no diagonal.
TEST_P(Facts, BesideAProtectedHalfFramesAreThoseOfTheProcessors) {
  if (GetParam().options.smoother != Smoother::kSchwarz) return;
  const TriangleMesh mesh = generate_scan({.kind = "tablet", .vertices = 5000}).value();
  Filtered here = session(mesh, 6), there(mesh, 6, {.backend = BackendKind::kCpu});
  for (Filtered* of : {&here, &there}) {
    EXPECT_TRUE(of->session().apply({"protect", half_of_it(mesh)}).is_ok());
    of->alpha(5).beta(0);
  }
  for (int frame = 1; frame <= 3; ++frame)
    EXPECT_LT(vertex_distance(here.after(1), there.after(1), here.diagonal()).max, 3e-4) << frame;
  const std::vector<Vec3d> moved = there.exact();
  EXPECT_LT(vertex_distance(here.exact(), moved, here.diagonal()).max, 2e-6);
  EXPECT_GT(vertex_distance(moved, mesh.vertices, here.diagonal()).max, 1e-2);
}

// The displacement of a signal that is not finite is not either.
TEST_P(Facts, AfterASystemThatIsNotFiniteTheNextOneIsSolvedAsByANewSolver) {
  const auto prepared = prepare(bumpy(), {.depth = 4}).value();
  const Multigrid on = make_multigrid(prepared).value();
  const size_t corners = on.hierarchy->depths.back().grid.corners.size();
  Fields fields(*prepared);
  fields.set_gradient_scale(0);
  std::vector<Vec3f> signal(corners, Vec3f::Zero());
  for (size_t i = 0; i < corners; i += 2) signal[i].x() = 1;
  const auto solve = [&](Solver& solver) {
    solver.set_signal(signal);
    solver.start_over(fields.view());
    EXPECT_TRUE(solver.solve(1e-6, 200).value().converged);
    return std::vector<Vec3f>(solver.vertex_displacement().begin(),
                              solver.vertex_displacement().end());
  };
  const auto fresh = Solver::create(on, GetParam().options).value();
  const auto failed = Solver::create(on, GetParam().options).value();
  failed->set_signal(std::vector<Vec3f>(corners, Vec3f(1, NAN, 1)));
  failed->set_metric(fields.view());
  EXPECT_TRUE(failed->step().fell_back);
  EXPECT_FALSE(failed->soundness().is_ok());
  for (const Vec3f& u : failed->displacement()) ASSERT_EQ(u, Vec3f::Zero());
  const std::vector<Vec3f> expected = solve(*fresh), found = solve(*failed);
  for (size_t v = 0; v < found.size(); ++v) ASSERT_LT((found[v] - expected[v]).norm(), 1e-4);
}

// If all cells have one β, the displacement is β − 1 times a part that only depends on the metric.
TEST_P(EverySmoother, AMovedSliderNeedsOneStep) {
  Filtered dragged = session(bumpy(), 5), fresh = session(bumpy(), 5);
  dragged.alpha(8).beta(0.5).exact();
  const auto expected = fresh.alpha(8).beta(3).exact();
  const auto moved = dragged.beta(3).after(1);
  EXPECT_LT(vertex_distance(moved, expected, fresh.diagonal()).max, 2e-5);
  EXPECT_GT(vertex_distance(moved, bumpy().vertices, fresh.diagonal()).max, 1e-2);
}

// Coordinates of a sphere are eigenfunctions with λ² = 2/r² and lie in the trial space.
TEST_P(Facts, ASphereShrinksByTheTransferFunctionAtEveryDepth) {
  const double radius = 2, alpha = 3, beta = 0.25;
  const TriangleMesh mesh = reference::icosphere(6, radius);
  for (int depth : {4, 7}) {
    Filtered filtered = session(mesh, depth);
    const auto moved = filtered.alpha(alpha).beta(beta).exact();
    const double length_unit = filtered.session().prepared().length_unit;
    const double a2 = std::pow(alpha / length_unit, 2), lambda2 = 2 / (radius * radius);
    const double scale = (a2 + beta * lambda2) / (a2 + lambda2);
    for (size_t v = 0; v < moved.size(); v += 97)
      EXPECT_NEAR((moved[v] - scale * mesh.vertices[v]).norm(), 0, 1e-3 * radius) << depth;
  }
}

// Colours that are its coordinates, in linear light, scale like them. Rounding to bytes hides in
// the mean over all vertices.
TEST_P(Facts, ColoursOfASphereScaleByTheTransferFunction) {
  TriangleMesh mesh = reference::icosphere(6, 1);
  for (const Vec3d& p : mesh.vertices) {
    const Vec3f linear = (Vec3d::Constant(0.5) + 0.4 * p).cast<float>();
    mesh.colours.push_back(
        {srgb_byte(linear.x()), srgb_byte(linear.y()), srgb_byte(linear.z()), 255});
  }
  Filtered filtered = session(mesh, 6);
  const double length_unit = filtered.session().prepared().length_unit;
  const ColourFilter filter{2 * length_unit, 0.25};
  ASSERT_TRUE(filtered.session().apply({"colours", SetColour{filter}}).is_ok());
  ASSERT_TRUE(filtered.session().solve({.exact = true}).is_ok());
  const TriangleMesh after = filtered.session().surface();
  double both = 0, square = 0;
  for (size_t v = 0; v < mesh.vertices.size(); ++v)
    for (int axis = 0; axis < 3; ++axis) {
      both += mesh.vertices[v][axis] * (linear_of_srgb(after.colours[v][axis]) - 0.5);
      square += 0.4 * mesh.vertices[v][axis] * mesh.vertices[v][axis];
    }
  EXPECT_NEAR(both / square, (4 + 0.25 * 2) / (4 + 2), 1e-3);
  EXPECT_EQ(after.vertices, mesh.vertices);
}

// Around the cylinder κ = 1/r takes one α. Along it κ = 0 takes the other. Both have closed forms.
TEST_P(Facts, AnOpenCylinderFollowsItsTwoClosedFormsAlignedAndTurned) {
  const double radius = 1, height = 2.5, around = 20, along = 4, beta = 2;
  const TriangleMesh upright = reference::open_cylinder(200, 160, radius, height);
  for (const Eigen::Matrix3d& turn :
       {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), reference::skew_turn()}) {
    const auto turned = [&](const Vec3d& p) { return Vec3d(turn * p); };
    Filtered filtered = session(reference::mapped(upright, turned), 5);
    const double length_unit = filtered.session().prepared().length_unit;
    const double kappa = length_unit / radius;
    filtered.beta(beta).curve(
        TransferCurve::create({{0.25 * kappa, along}, {0.75 * kappa, around}}).value());
    const auto moved = filtered.exact();
    const double a1 = around / length_unit, a2 = along / length_unit;
    const double across = (a1 * a1 + beta) / (a1 * a1 + 1);
    for (size_t v = 0; v < moved.size(); v += 7) {
      const Vec3d& p = upright.vertices[v];
      const double z =
          p.z() + (beta - 1) * std::sinh(a2 * p.z()) / (a2 * std::cosh(a2 * height / 2));
      const Vec3d error = turn.transpose() * moved[v] - Vec3d(across * p.x(), across * p.y(), z);
      ASSERT_LT(error.head<2>().norm(), 5e-4) << "vertex " << v;
      ASSERT_LT(std::abs(error.z()), 2e-3) << "vertex " << v;  // sinh is not trilinear
    }
  }
}

// It holds over the true surface x(p). Triangles much smaller than cells bring the vertices'
// centroid close to it.
TEST_P(EverySmoother, ConstantAlphaKeepsTheCentroid) {
  const TriangleMesh mesh = reference::bumpy_sphere(6);
  const auto centroid = [&](const std::vector<Vec3d>& vertices) {
    Vec3d sum = Vec3d::Zero();
    double area = 0;
    for (const Triangle& t : mesh.triangles) {
      const Vec3d& a = mesh.vertices[t[0]];
      const double twice = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
      sum += twice * (vertices[t[0]] + vertices[t[1]] + vertices[t[2]]) / 3;
      area += twice;
    }
    return Vec3d(sum / area);
  };
  Filtered filtered = session(mesh, 4);
  filtered.alpha(5).beta(0);
  filtered.paint({{.radius = 0.7, .strength = 1, .beta = 1}, {mesh.vertices[0]}});
  const Vec3d moved = centroid(filtered.exact()) - centroid(mesh.vertices);
  EXPECT_LE(moved.norm() / filtered.diagonal(), 1e-6);
}

TEST_P(EverySmoother, EnergyNeverRises) {
  Filtered filtered = session(bumpy(), 5);
  filtered.curve(contrast_100()).beta(0);
  double before = 0;  // of u = 0
  for (int i = 0; i < 60; ++i) {
    const double energy = filtered.session().step().energy;
    EXPECT_LE(energy, before + 1e-12 * std::abs(before)) << i;
    before = energy;
  }
}

TEST_P(Facts, ReversedWindingGivesTheSameSurface) {
  const TriangleMesh mesh = bumpy();
  const auto curve = contrast_100();
  Filtered one = session(mesh, 5), other = session(reference::turned_inside_out(mesh), 5);
  const auto a = one.curve(curve).beta(0.5).exact(), b = other.curve(curve).beta(0.5).exact();
  EXPECT_LE(vertex_distance(a, b, one.diagonal()).max, 1e-6);
}

TEST_P(Facts, UnitsPoseAndPlaceDoNotMatter) {
  const TriangleMesh mesh = bumpy();
  const auto map = [](const Vec3d& p) {
    return Vec3d(1000 * Vec3d(-p.y(), p.x(), p.z()) + Vec3d(5e4, -3e4, 1e4));  // a quarter turn
  };
  const auto curve = contrast_100();
  Filtered one = session(mesh, 5), other = session(reference::mapped(mesh, map), 5);
  auto a = one.curve(curve).beta(0.5).exact();
  const auto b = other.curve(curve).beta(0.5).exact();
  for (Vec3d& v : a) v = map(v);
  EXPECT_LE(vertex_distance(a, b, other.diagonal()).max, 1e-6);
}

float largest(std::span<const Vec3f> displacement) {
  float most = 0;
  for (const Vec3f& u : displacement) most = std::max(most, u.norm());
  return most;
}

// Over two thousand frames without work, no energy and no vertex drifts. No corner runs away, even
// if no vertex depends on it.
TEST_P(Facts, AnIdleSessionStaysWhereItSettled) {
  for (const TransferCurve& curve :
       {TransferCurve(1), TransferCurve(50), TransferCurve::parse("-20:1,20:1000").value()}) {
    SCOPED_TRACE(curve.to_string());
    Filtered filtered = session(bumpy(), 4);
    filtered.curve(curve).beta(0);
    const auto settled = filtered.exact();
    Session& live = filtered.session();
    const float corners_reach = largest(live.solver().displacement());
    double before = live.step().energy;
    for (int i = 1; i < 2000; ++i) {
      const double energy = live.step().energy;
      ASSERT_LE(energy, before + 1e-12 * std::abs(before)) << "frame " << i;
      before = energy;
    }
    const auto later = live.surface().vertices;
    EXPECT_LE(vertex_distance(settled, later, filtered.diagonal()).max, 1e-6);
    EXPECT_LE(largest(live.solver().displacement()), 2 * corners_reach);
  }
}

// The dabs change α in a part of the cells: a live session makes only their matrices again.
TEST_P(EverySmoother, DabsOfCurvesEndWhereAFreshSessionDoes) {
  const TriangleMesh mesh = bumpy();
  const Palette palette{{{"even", 0, TransferCurve(10)}, {"by curvature", 0, contrast_100()}}};
  const auto dab = [&](size_t vertex, int curve) {
    return Stroke{{.radius = 0.3, .strength = 0.8, .curve = curve}, {mesh.vertices[vertex]}};
  };
  Filtered live = session(mesh, 6), fresh = session(mesh, 6), without = session(mesh, 6);
  live.alpha(40).beta(0).palette(palette).exact();
  live.paint(dab(7, 1)).after(1);
  live.paint(dab(900, 1)).after(2);
  live.paint(dab(7, 2)).after(1);
  fresh.alpha(40).beta(0).palette(palette);
  fresh.paint(dab(7, 1)).paint(dab(900, 1)).paint(dab(7, 2));
  const auto painted = live.exact(), plain = without.alpha(40).beta(0).exact();
  EXPECT_LE(vertex_distance(painted, fresh.exact(), fresh.diagonal()).max, 2e-6);
  EXPECT_GT(vertex_distance(painted, plain, fresh.diagonal()).max, 1e-4);
}

TEST_P(Facts, ADabOfACurveSettlesInThreeFrames) {
  const TriangleMesh mesh = bumpy();
  const Palette palette{{{"even", 0, TransferCurve(5)}}};
  const Stroke dab{{.radius = 0.3, .strength = 1, .curve = 1}, {mesh.vertices[7]}};
  Filtered live = session(mesh, 6);
  live.alpha(50).beta(0).palette(palette).exact();
  live.paint(dab);
  const auto moved = live.after(3);
  EXPECT_LE(vertex_distance(moved, live.exact(), live.diagonal()).max, 1e-3);
}

std::string case_name(const testing::TestParamInfo<BackendCase>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Backends, Facts, testing::ValuesIn(backend_cases()), case_name);
INSTANTIATE_TEST_SUITE_P(Backends, EverySmoother, testing::ValuesIn(every_smoother_cases()),
                         case_name);

// The bars of interactive use; they hold for the default smoother.
class Interactive : public Facts {};

TEST_P(Interactive, AColdIsotropicStartMeetsTheBars) {
  for (double alpha : {5.0, 50.0}) {
    const TriangleMesh mesh = bumpy();
    const auto converged = exact(mesh, 6, alpha, 0);
    Filtered filtered = session(mesh, 6);
    filtered.alpha(alpha).beta(0);
    const auto error = [&](int more) {
      return vertex_distance(filtered.after(more), converged, filtered.diagonal()).max;
    };
    EXPECT_LE(error(3), 1e-3) << alpha;
    EXPECT_LE(error(2), 1e-4) << alpha;
    EXPECT_LE(error(5), 1e-5) << alpha;
  }
}

// A V-cycle alone leaves 8e-4.
TEST_P(Interactive, AColdStartIsNearlyThereAfterOneFrame) {
  const TriangleMesh mesh = bumpy();
  const auto converged = exact(mesh, 6, 5, 0);
  Filtered filtered = session(mesh, 6);
  filtered.alpha(5).beta(0);
  EXPECT_LE(vertex_distance(filtered.after(1), converged, filtered.diagonal()).max, 1e-4);
}

TEST_P(Interactive, AColdCurveOfContrastHundredMeetsTheBars) {
  const TriangleMesh mesh = bumpy();
  const auto converged = session(mesh, 6).curve(contrast_100()).beta(0).exact();
  Filtered filtered = session(mesh, 6);
  filtered.curve(contrast_100()).beta(0);
  EXPECT_LE(vertex_distance(filtered.after(5), converged, filtered.diagonal()).max, 1e-2);
  EXPECT_LE(vertex_distance(filtered.after(5), converged, filtered.diagonal()).max, 1e-3);
}

TEST_P(Interactive, ASliderStepAndAStrokeSettleInThreeFrames) {
  const TriangleMesh mesh = bumpy();
  const Stroke stroke{{.radius = 0.3, .strength = 1, .beta = 2}, {mesh.vertices[7]}};
  Filtered live = session(mesh, 6);
  live.alpha(50).beta(0.5).exact();
  live.beta(0.6);
  const auto slid = session(mesh, 6).alpha(50).beta(0.6).exact();
  EXPECT_LE(vertex_distance(live.after(3), slid, live.diagonal()).max, 1e-4);
  live.paint(stroke);
  const auto painted = session(mesh, 6).alpha(50).beta(0.6).paint(stroke).exact();
  EXPECT_LE(vertex_distance(live.after(3), painted, live.diagonal()).max, 1e-4);
}

TEST_P(Interactive, ACurveStepSettlesInFiveFrames) {
  const TriangleMesh mesh = bumpy();
  const auto stepped = TransferCurve::parse("-20:6.25,20:500").value();
  Filtered live = session(mesh, 6);
  live.curve(contrast_100()).beta(0).exact();
  live.curve(stepped);
  const auto converged = session(mesh, 6).curve(stepped).beta(0).exact();
  EXPECT_LE(vertex_distance(live.after(5), converged, live.diagonal()).max, 1e-3);
}

std::vector<BackendCase> default_smoother_cases() {
  std::vector<BackendCase> cases = backend_cases();
  std::erase_if(cases, [](const auto& c) { return c.options.smoother != Smoother::kSchwarz; });
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Backends, Interactive, testing::ValuesIn(default_smoother_cases()),
                         case_name);

}  // namespace
}  // namespace burnish
