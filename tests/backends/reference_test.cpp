// Every backend against the independent double-precision reference, on the awkward meshes.

#include "tests/reference/reference.h"

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "common/grid/morton.h"
#include "tests/backends/filtered.h"
#include "tests/reference/awkward_meshes.h"
#include "tests/reference/compare.h"
#include "tests/reference/shapes.h"

namespace burnish {
namespace {

constexpr int kDepth = 5;
constexpr double kExportMax = 1e-5, kExportRms = 1e-6;  // docs/solver.md, "How exact"
constexpr double kSettledMax = 1e-4, kSettledRms = 1e-5;
constexpr double kCurveMax = 5e-4, kCurveRms = 5e-5;

// A flat part along the grid leaves the answer open: trilinear functions vanish on it, and direct
// solvers in double differ by more than the bar of exports. The list also holds the same sheet
// turned.
constexpr std::string_view kOpenAnswer = "open sheet with flat parts";

struct Filter {
  std::string name;
  TransferCurve curve;
  double beta;
};

std::vector<Filter> filters() {
  return {{"alpha_5_beta_0", TransferCurve(5), 0},
          {"alpha_50_beta_2", TransferCurve(50), 2},
          {"contrast_100", TransferCurve::parse("-20:5,20:500").value(), 0.5}};
}

using Case = std::tuple<BackendCase, Filter>;

class AgainstReference : public testing::TestWithParam<Case> {
 protected:
  // The reference's factorisation is expensive, so both bars use one solution.
  void compare(const std::string& name, const TriangleMesh& mesh) {
    SCOPED_TRACE(name);
    const auto& [backend, filter] = GetParam();
    const reference::System system = reference::build(mesh, kDepth);
    const auto expected =
        reference::edited_vertices(system, reference::fields(system, filter.curve, filter.beta));
    Filtered filtered(mesh, kDepth, backend.options);
    filtered.curve(filter.curve).beta(filter.beta);

    const bool isotropic = filter.curve.is_constant();
    const auto settled =
        reference::vertex_distance(filtered.settled(), expected, filtered.diagonal());
    EXPECT_LE(settled.max, isotropic ? kSettledMax : kCurveMax);
    EXPECT_LE(settled.rms, isotropic ? kSettledRms : kCurveRms);
    if (name == kOpenAnswer) return;
    const auto exact = reference::vertex_distance(filtered.exact(), expected, filtered.diagonal());
    EXPECT_LE(exact.max, kExportMax);
    EXPECT_LE(exact.rms, kExportRms);
  }
};

TEST_P(AgainstReference, AwkwardMeshesMeetTheSettledAndExportBars) {
  for (const auto& [name, mesh] : reference::awkward_meshes()) compare(name, mesh);
}

// Slivers and specks of a torn wall have corners whose diagonals are far below the others': pins
// must not move them. α is as small on this grid as 1 is on one of depth 8.
TEST(TornWall, MeetsTheBarsAtAContrastOf1000) {
  const TriangleMesh mesh = generate_scan({.kind = "wall", .vertices = 30'000}).value();
  const auto curve = TransferCurve::parse("-20:0.25,20:250").value();
  const reference::System system = reference::build(mesh, kDepth);
  const auto expected = reference::edited_vertices(system, reference::fields(system, curve, 2.0));
  for (const BackendCase& backend : backend_cases()) {
    if (backend.options.smoother != Smoother::kSchwarz) continue;
    SCOPED_TRACE(backend.name);
    Filtered filtered(mesh, kDepth, backend.options);
    filtered.curve(curve).beta(2);
    const auto exact = reference::vertex_distance(filtered.exact(), expected, filtered.diagonal());
    EXPECT_LE(exact.max, kExportMax);
    EXPECT_LE(exact.rms, kExportRms);
  }
}

// Gives the reference every cell's painted β from the product's blending.
TEST_P(AgainstReference, APaintedSphereMeetsTheBars) {
  const auto& [backend, filter] = GetParam();
  const TriangleMesh mesh = reference::bumpy_sphere(4);
  Filtered filtered(mesh, kDepth, backend.options);
  filtered.curve(filter.curve).beta(filter.beta);
  filtered.paint(
      {{.radius = 0.5, .strength = 0.8, .beta = 3}, {mesh.vertices[3], mesh.vertices[9]}});
  const reference::System system = reference::build(mesh, kDepth);
  auto fields = reference::fields(system, filter.curve, filter.beta);
  const auto beta = filtered.session().fields().view().beta;
  const auto& cells = filtered.session().prepared().cells;
  ASSERT_EQ(cells.size(), system.cells.size());
  for (size_t c = 0; c < cells.size(); ++c) {
    const Vec3i place = morton_point(cells[c]);
    const reference::Cell* cell = system.find_cell({place.x(), place.y(), place.z()});
    ASSERT_NE(cell, nullptr);
    fields[cell - system.cells.data()].beta = beta[c];
  }
  const auto expected = reference::edited_vertices(system, fields);
  const auto exact = reference::vertex_distance(filtered.exact(), expected, filtered.diagonal());
  EXPECT_LE(exact.max, kExportMax);
  EXPECT_LE(exact.rms, kExportRms);
}

std::string reference_case_name(const testing::TestParamInfo<Case>& info) {
  return std::get<0>(info.param).name + "_" + std::get<1>(info.param).name;
}

INSTANTIATE_TEST_SUITE_P(Backends, AgainstReference,
                         testing::Combine(testing::ValuesIn(backend_cases()),
                                          testing::ValuesIn(filters())),
                         reference_case_name);

}  // namespace
}  // namespace burnish
