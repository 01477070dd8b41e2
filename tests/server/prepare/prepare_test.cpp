#include "server/prepare/prepare.h"

#include <cmath>
#include <cstring>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "common/grid/depth_plan.h"
#include "server/prepare/piece_count.h"
#include "tests/reference/awkward_meshes.h"

namespace burnish {
namespace {

using testing::AllOf;
using testing::HasSubstr;

PrepareOptions at_depth(int depth) {
  PrepareOptions options;
  options.depth = depth;
  return options;
}

template <typename T>
bool same_bits(std::span<const T> a, std::span<const T> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

template <typename Number, typename Struct>
bool all_finite(const Struct& numbers) {
  std::array<Number, sizeof(Struct) / sizeof(Number)> values;
  std::memcpy(values.data(), &numbers, sizeof(Struct));
  return std::all_of(values.begin(), values.end(), [](Number x) { return std::isfinite(x); });
}

TEST(Prepare, MassOfAllCellsIsTheMeshsArea) {
  for (const auto& [name, mesh] : reference::awkward_meshes()) {
    SCOPED_TRACE(name);
    const auto prepared = prepare(mesh, at_depth(5));
    ASSERT_TRUE(prepared.is_ok()) << prepared.status().message();
    const PreparedMesh& p = **prepared;
    double mass = 0, area = 0;
    for (const CellIntegrals& cell : p.integrals)
      for (float row : cell.mass_row_sum) mass += row;
    for (const CellCurvature& cell : p.curvature) area += cell.area;
    const double expected = p.statistics.area / (p.frame.cell_size * p.frame.cell_size);
    EXPECT_NEAR(mass, expected, 1e-6 * expected);
    EXPECT_NEAR(area, expected, 1e-6 * expected);
    EXPECT_DOUBLE_EQ(p.length_unit, std::sqrt(p.statistics.area));
  }
}

TEST(Prepare, GivesFiniteNumbersForAwkwardMeshes) {
  for (const auto& [name, mesh] : reference::awkward_meshes()) {
    SCOPED_TRACE(name);
    const auto prepared = prepare(mesh, {});
    ASSERT_TRUE(prepared.is_ok()) << prepared.status().message();
    const PreparedMesh& p = **prepared;
    EXPECT_TRUE(std::is_sorted(p.cells.begin(), p.cells.end(), std::less_equal<>()));
    EXPECT_TRUE(
        std::all_of(p.integrals.begin(), p.integrals.end(), all_finite<double, CellIntegrals>));
    EXPECT_TRUE(
        std::all_of(p.curvature.begin(), p.curvature.end(), all_finite<float, CellCurvature>));
    EXPECT_EQ(p.evaluation.size(), mesh.vertices.size());
  }
}

TEST(Prepare, GivesTheSameBitsForAnyNumberOfThreads) {
  const TriangleMesh mesh = reference::several_components();
  PrepareOptions options = at_depth(6);
  options.curvature_radius = 0.02;
  options.threads = 1;
  const auto one = *prepare(mesh, options);
  options.threads = 2;
  const auto two = *prepare(mesh, options);
  EXPECT_TRUE(same_bits(one->cells, two->cells));
  EXPECT_TRUE(same_bits(one->integrals, two->integrals));
  EXPECT_TRUE(same_bits(one->curvature, two->curvature));
  EXPECT_TRUE(same_bits(one->passages, two->passages));
  EXPECT_TRUE(same_bits(one->evaluation, two->evaluation));
  EXPECT_EQ(one->histogram.area, two->histogram.area);
}

TEST(Prepare, GivesTheSamePassagesInDoubtForAnyNumberOfThreads) {
  const TriangleMesh mesh = reference::stepped_block(2);
  PrepareOptions options = at_depth(6);
  options.threads = 1;
  const auto one = *prepare(mesh, options);
  options.threads = 2;
  EXPECT_TRUE(same_bits(one->passages, (*prepare(mesh, options))->passages));
}

TEST(Prepare, ReportsItsPhasesInOrder) {
  std::vector<std::string> phases;
  double last = 0;
  const auto watch = [&](std::string_view phase, double fraction) {
    if (phases.empty() || phases.back() != phase) {
      phases.emplace_back(phase);
      last = 0;
    }
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1);
    last = fraction;
    return true;
  };
  PrepareReport report;
  ASSERT_TRUE(prepare(make_icosphere(4, 1), at_depth(6), watch, &report).is_ok());
  EXPECT_THAT(phases,
              testing::ElementsAre("statistics", "grid", "curvature", "integrals", "evaluation"));
  EXPECT_EQ(report.phases.size(), 5u);  // and statistics before them
}

// Two spheres in each other have sheets, and a radius has averages.
TEST(Prepare, CanBeCancelledWheneverItReportsAndEachOfItsLoopsDoes) {
  constexpr int kLoops = 36;
  const TriangleMesh mesh = reference::joined(make_icosphere(4, 1), make_icosphere(4, 1.01));
  PrepareOptions options = at_depth(6);
  options.curvature_radius = 0.1;
  for (int until = 1;; ++until) {
    int left = until;
    const auto result = prepare(mesh, options, [&](auto, auto) { return --left > 0; });
    if (left > 0) {  // there were fewer reports: loops also report by the clock
      EXPECT_TRUE(result.is_ok());
      EXPECT_GT(until, kLoops);
      break;
    }
    ASSERT_FALSE(result.is_ok()) << until;
    EXPECT_EQ(result.status().code(), StatusCode::kCancelled);
    EXPECT_EQ(left, 0) << "went on after report " << until;
  }
}

TEST(Prepare, RefusesADepthOrRadiusOutsideItsLimits) {
  const TriangleMesh mesh = make_icosphere(2, 1);
  for (int depth : {-1, 1, 3, 13}) {
    const auto result = prepare(mesh, at_depth(depth));
    ASSERT_FALSE(result.is_ok());
    EXPECT_EQ(result.status().code(), StatusCode::kInvalidArgument);
    EXPECT_THAT(result.status().message(),
                AllOf(HasSubstr("depth " + std::to_string(depth)), HasSubstr("4..12")));
  }
  for (double radius : {-0.1, 0.3, std::nan("")}) {
    PrepareOptions options = at_depth(4);
    options.curvature_radius = radius;
    const auto result = prepare(mesh, options);
    ASSERT_FALSE(result.is_ok());
    EXPECT_EQ(result.status().code(), StatusCode::kInvalidArgument);
    EXPECT_THAT(result.status().message(), HasSubstr("curvature radius"));
  }
}

TEST(Prepare, ChoosesTheDefaultDepthUnlessTold) {
  const TriangleMesh mesh = make_icosphere(5, 1);
  const auto chosen = *prepare(mesh, {});
  const MeshStatistics& s = chosen->statistics;
  EXPECT_EQ(chosen->frame.depth, default_depth(s, UINT64_MAX));
  EXPECT_EQ((*prepare(mesh, at_depth(4)))->frame.depth, 4);
}

TEST(Prepare, KeepsTheMeshAsGiven) {
  TriangleMesh mesh = make_icosphere(2, 1);
  mesh.colours.assign(mesh.vertices.size(), {1, 2, 3, 4});
  mesh.has_double_positions = true;
  const auto prepared = *prepare(mesh, at_depth(4));
  EXPECT_TRUE(same_bits(prepared->vertices, std::span<const Vec3d>(mesh.vertices)));
  EXPECT_TRUE(same_bits(prepared->triangles, std::span<const Triangle>(mesh.triangles)));
  EXPECT_TRUE(same_bits(prepared->colours, std::span<const Rgba8>(mesh.colours)));
  EXPECT_TRUE(prepared->has_double_positions);
}

TEST(Prepare, RefusesAMeshOfNeedlesWithoutArea) {
  const TriangleMesh thread = {{{0, 0, 0}, {1, 0, 0}, {1, 1e-26, 0}}, {{0, 1, 2}}};
  ASSERT_TRUE(validate(thread).is_ok());
  const auto prepared = prepare(thread, at_depth(4));
  ASSERT_FALSE(prepared.is_ok());
  EXPECT_EQ(prepared.status().code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(prepared.status().message(), HasSubstr("all 1 triangles are too thin"));
}

TEST(Prepare, NamesTheCellInWhichAScanIsLostBesideAFarVertex) {
  TriangleMesh mesh = make_icosphere(2, 1);
  mesh.vertices.emplace_back(1e17, 0, 0);
  mesh.triangles.push_back({0, 1, static_cast<uint32_t>(mesh.vertices.size() - 1)});
  const auto prepared = prepare(mesh, at_depth(4));
  EXPECT_EQ(prepared.status().code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(prepared.status().message(), HasSubstr("cells of 6.9"));
}

// Counting the cells of all of them would never end.
TEST(Prepare, CountsNoMorePiecesThanItMay) {
  const std::vector<Vec3d> triangle = {{0.5, 0, 0}, {0.5, 4096, 0}, {0.5, 0, 4096}};
  const std::vector<Triangle> triangles(5'000'000, Triangle{0, 1, 2});
  const auto pieces = count_cell_pieces({triangles, triangle, 12}, 100'000'000, {});
  EXPECT_EQ(pieces.status().code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(pieces.status().message(), HasSubstr("more than 100000000 pieces"));
}

TEST(Prepare, HearsACancelBetweenTwoTrianglesThatItCounts) {
  const std::vector<Vec3d> triangle = {{0.5, 0, 0}, {0.5, 4096, 0}, {0.5, 0, 4096}};
  const std::vector<Triangle> triangles(5'000'000, Triangle{0, 1, 2});
  int asked = 0;
  const Progress cancel = [&](std::string_view, double) { return ++asked < 2; };
  const auto pieces = count_cell_pieces({triangles, triangle, 12}, UINT64_MAX, cancel);
  EXPECT_EQ(pieces.status().code(), StatusCode::kCancelled);
  EXPECT_EQ(asked, 2);
}

}  // namespace
}  // namespace burnish
