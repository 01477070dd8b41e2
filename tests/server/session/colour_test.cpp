#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/evaluation/evaluation.h"
#include "common/generate/generate.h"
#include "common/mesh/srgb.h"
#include "server/session/fit_signal.h"
#include "tests/server/session/solved_session.h"

namespace burnish {
namespace {

using testing::HasSubstr;

// Harmonics of order 1, 2 and 3 on the unit sphere: λ² = 2, 6 and 12. Within ±1.
Vec3d harmonics(const Vec3d& p) {
  return {p.x(), 2 * p.x() * p.y(), 5 * p.x() * p.y() * p.z()};
}

Rgba8 colour_of(const Vec3d& linear, uint8_t alpha = 200) {
  const Vec3f of = linear.cast<float>();
  return {srgb_byte(of.x()), srgb_byte(of.y()), srgb_byte(of.z()), alpha};
}

TriangleMesh coloured_sphere(int divisions) {
  TriangleMesh sphere = make_icosphere(divisions, 1);
  for (const Vec3d& p : sphere.vertices)
    sphere.colours.push_back(colour_of(Vec3d::Constant(0.5) + 0.4 * harmonics(p)));
  return sphere;
}

double linear_at(const TriangleMesh& mesh, size_t vertex, int channel) {
  return linear_of_srgb(mesh.colours[vertex][channel]);
}

// Returns by how much a channel's wave is multiplied: the best factor over all vertices.
double gain_of(const TriangleMesh& before, const TriangleMesh& after, int channel) {
  double both = 0, square = 0;
  for (size_t v = 0; v < before.vertices.size(); ++v) {
    const double wave = harmonics(before.vertices[v])[channel];
    both += wave * (linear_at(after, v, channel) - 0.5);
    square += wave * wave * 0.4;
  }
  return both / square;
}

TEST(Colours, ExactResultsFollowFromTheEditsAlone) {
  const TriangleMesh sphere = coloured_sphere(4);
  const auto live = session_over(sphere), at_once = session_over(sphere);
  exact_surface(*live, {SetColour{{3, 2}}});
  const SetColour last{{8, 0.25}};
  EXPECT_TRUE(live->apply({"colours", last}).is_ok());
  for (int i = 0; i < 3; ++i) live->step();
  EXPECT_TRUE(live->apply({"slider", SetGradientScale{0.5}}).is_ok());
  const TriangleMesh expected = exact_surface(*at_once, {last, SetGradientScale{0.5}});
  const TriangleMesh found = exact_surface(*live, {});
  EXPECT_EQ(found.vertices, expected.vertices);
  EXPECT_EQ(found.colours, expected.colours);
  EXPECT_NE(found.colours, sphere.colours);
}

TEST(Colours, HarmonicsOfASphereScaleAsTheFormulaSays) {
  const TriangleMesh sphere = coloured_sphere(6);
  const auto session = session_over(sphere, 7);
  const double length = session->prepared().length_unit;
  const ColourFilter filter{4 * length, 0.25};
  const TriangleMesh filtered = exact_surface(*session, {SetColour{filter}});
  for (int channel = 0; channel < 3; ++channel) {
    const double square = (channel + 1) * (channel + 2), a = filter.alpha / length;
    const double expected = (a * a + filter.beta * square) / (a * a + square);
    EXPECT_NEAR(gain_of(sphere, filtered, channel), expected, 1e-3) << "channel " << channel;
  }
  EXPECT_EQ(filtered.vertices, sphere.vertices);
}

TEST(Colours, ABetaOfOneReturnsTheScanExactly) {
  const TriangleMesh sphere = coloured_sphere(4);
  const auto session = session_over(sphere);
  exact_surface(*session, {SetColour{{10, 0}}});
  EXPECT_EQ(exact_surface(*session, {SetColour{{10, 1}}}).colours, sphere.colours);
}

TEST(Colours, OneColourEverywhereStays) {
  TriangleMesh sphere = make_icosphere(4, 1);
  sphere.colours.assign(sphere.vertices.size(), Rgba8{17, 130, 255, 9});
  const auto session = session_over(sphere);
  EXPECT_EQ(exact_surface(*session, {SetColour{{5, 3}}}).colours, sphere.colours);
}

TEST(Colours, StayWhereTheShapeIsEdited) {
  const TriangleMesh sphere = coloured_sphere(4);
  const auto session = session_over(sphere);
  const TriangleMesh smooth = exact_surface(*session, {SetGradientScale{0}});
  EXPECT_EQ(smooth.colours, sphere.colours);
  EXPECT_NE(smooth.vertices, sphere.vertices);
}

TEST(Colours, AreCutOffAtBlackAndWhite) {
  const TriangleMesh sphere = coloured_sphere(4);
  const auto session = session_over(sphere);
  const TriangleMesh sharp = exact_surface(*session, {SetColour{{1, 10}}});
  uint8_t least = 255, most = 0;
  for (const Rgba8& colour : sharp.colours) {
    least = std::min(least, colour[0]);
    most = std::max(most, colour[0]);
    ASSERT_EQ(colour[3], 200);
  }
  EXPECT_EQ(least, 0);
  EXPECT_EQ(most, 255);
}

TEST(Colours, ABrushFiltersThemUnderItAlone) {
  const TriangleMesh sphere = coloured_sphere(5);
  Stroke stroke{{0.5, 1, 0, FallOff::kConstant}, {Vec3d(0, 0, 1)}};
  stroke.brush.colour = true;
  const auto session = session_over(sphere, 6);
  const TriangleMesh painted = exact_surface(*session, {SetColour{{60, 1}}, stroke});
  size_t changed = 0;
  for (size_t v = 0; v < sphere.vertices.size(); ++v) {
    if (painted.colours[v] == sphere.colours[v]) continue;
    ++changed;
    ASSERT_LT((sphere.vertices[v] - Vec3d(0, 0, 1)).norm(), 0.9);
  }
  EXPECT_GT(changed, 10u);
  EXPECT_EQ(painted.vertices, sphere.vertices);
}

TEST(Colours, AreKeptInTheProtectedRegion) {
  const TriangleMesh sphere = coloured_sphere(4);
  const auto session = session_over(sphere);
  Protect all;
  all.way = PieceRegion{Vec3d(0, 0, 1)};
  EXPECT_EQ(exact_surface(*session, {all, SetColour{{10, 0}}}).colours, sphere.colours);
}

TEST(Colours, AnUndoBringsThemBack) {
  const TriangleMesh sphere = coloured_sphere(4);
  const auto session = session_over(sphere);
  EXPECT_NE(exact_surface(*session, {SetColour{{10, 0}}}).colours, sphere.colours);
  EXPECT_EQ(exact_surface(*session, {Undo{}}).colours, sphere.colours);
}

TEST(Colours, OfAScanWithoutAnyAreRefused) {
  const auto session = session_over(make_icosphere(3, 1));
  const Status refused = session->edited().check_new({"c", SetColour{{10, 0}}});
  EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(refused.message(), HasSubstr("no colours"));
}

TEST(Colours, AStepOfThemLeavesTheSurfaceInPlace) {
  const auto session = session_over(coloured_sphere(4));
  exact_surface(*session, {SetGradientScale{0.5}});
  const std::vector<Vec3f> before(session->displacement().begin(), session->displacement().end());
  ASSERT_TRUE(session->apply({"c", SetColour{{10, 0}}}).is_ok());
  const StepReport last = session->step();
  EXPECT_FALSE(session->is_settled(last));
  EXPECT_TRUE(std::ranges::equal(session->displacement(), before));
  EXPECT_GT(std::ranges::max(session->colour_change().on_grid, {}, &Vec3f::norm).norm(), 0);
}

// Each vertex has a colour of its own, so nearly all of it is finer than a cell.
TriangleMesh noisy_sphere(int divisions) {
  TriangleMesh sphere = make_icosphere(divisions, 1);
  std::mt19937 random(7);
  for (size_t v = 0; v < sphere.vertices.size(); ++v)
    sphere.colours.push_back({static_cast<uint8_t>(128 + int(random() % 61) - 30),
                              static_cast<uint8_t>(random() % 2 * 255), 128, 255});
  return sphere;
}

double roughness(const TriangleMesh& mesh, int channel) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles)
    sum += std::pow(linear_at(mesh, t[0], channel) - linear_at(mesh, t[1], channel), 2);
  return std::sqrt(sum / double(mesh.triangles.size()));
}

TEST(Colours, NoiseFromVertexToVertexIsSmoothedThoughACellIsTwoEdges) {
  const TriangleMesh sphere = noisy_sphere(4);
  const auto session = session_over(sphere, 4);
  const double cell = session->prepared().frame.cell_size;
  ASSERT_GT(cell, 1.8 * session->prepared().statistics.mean_edge_length);
  const TriangleMesh smooth = exact_surface(*session, {SetColour{{20, 0}}});
  for (const int channel : {0, 1})
    EXPECT_LT(roughness(smooth, channel), 0.05 * roughness(sphere, channel)) << channel;
  const TriangleMesh sharp = exact_surface(*session, {SetColour{{20, 2}}});
  EXPECT_NEAR(roughness(sharp, 0) / roughness(sphere, 0), 2, 0.05);
}

TEST(Colours, DoNotDependOnTheDepthWhereACellIsAnEdgeOrTwo) {
  const TriangleMesh sphere = noisy_sphere(4);
  const TriangleMesh coarse = exact_surface(*session_over(sphere, 4), {SetColour{{20, 0}}});
  const TriangleMesh fine = exact_surface(*session_over(sphere, 5), {SetColour{{20, 0}}});
  double sum = 0;
  for (size_t v = 0; v < sphere.vertices.size(); ++v)
    sum += std::pow(coarse.colours[v][0] - fine.colours[v][0], 2);
  EXPECT_LT(std::sqrt(sum / double(sphere.vertices.size())), 1);
}

TEST(Colours, OfTrianglesThatShareNoVertexAreThoseOfTheWholeMesh) {
  const TriangleMesh sphere = noisy_sphere(4);
  TriangleMesh apart;
  for (const Triangle& t : sphere.triangles) {
    const auto first = static_cast<uint32_t>(apart.vertices.size());
    for (const uint32_t v : t) {
      apart.vertices.push_back(sphere.vertices[v]);
      apart.colours.push_back(sphere.colours[v]);
    }
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  const TriangleMesh whole = exact_surface(*session_over(sphere), {SetColour{{10, 0}}});
  const TriangleMesh parts = exact_surface(*session_over(apart), {SetColour{{10, 0}}});
  double sum = 0;
  for (size_t t = 0; t < sphere.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
      sum += std::pow(parts.colours[3 * t + i][1] - whole.colours[sphere.triangles[t][i]][1], 2);
  EXPECT_LT(std::sqrt(sum / double(apart.vertices.size())), 1);
}

TEST(FitSignal, OfNoiseMeetsItsBar) {
  const TriangleMesh sphere = noisy_sphere(4);
  const Multigrid mesh = make_multigrid(prepare(sphere, {.depth = 4}).value()).value();
  std::vector<Vec3f> linear;
  for (const Rgba8& colour : sphere.colours)
    linear.emplace_back(linear_of_srgb(colour[0]), linear_of_srgb(colour[1]), 0.5F);
  const SignalFit fit = fit_signal(mesh, linear);
  EXPECT_TRUE(fit.is_met);
  EXPECT_GT(fit.steps, 10);
}

TEST(FitSignal, MeetsAFunctionThatTheGridHolds) {
  const TriangleMesh sphere = make_icosphere(5, 1);
  const Multigrid mesh = make_multigrid(prepare(sphere, {.depth = 5}).value()).value();
  std::vector<Vec3f> linear;
  for (const Vec3d& p : sphere.vertices) linear.push_back(p.cast<float>());
  const std::vector<Vec3f> fitted = fit_signal(mesh, linear).corners;
  const SparseGrid& grid = mesh.hierarchy->at(mesh.hierarchy->finest).grid;
  for (size_t v = 0; v < linear.size(); ++v) {
    const Vec3f at =
        evaluate<Vec3f>(grid, mesh.prepared->evaluation[v], std::span<const Vec3f>(fitted));
    ASSERT_LT((at - linear[v]).norm(), 1e-3);
  }
}

}  // namespace
}  // namespace burnish
