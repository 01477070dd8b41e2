// Facts about kept edges on every backend.

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "server/solver/cuda/cuda_backend.h"
#include "tests/backends/filtered.h"
#include "tests/backends/on_a_device.h"

namespace burnish {
namespace {

constexpr int kDepthOfPart = 5;

TriangleMesh noisy_part() {
  return generate_scan(
             {.kind = "part", .vertices = 2500, .noise = 0.2, .noise_kind = NoiseKind::kGauss})
      .value();
}

EdgeFilter machined(double strength, double crispness = 1) {
  EdgeFilter filter = find_edge_preset("machined").value().filter;
  filter.strength = strength;
  filter.crispness = crispness;
  return filter;
}

// Every way to another constraint: sliders, matrices, paint, metrics, and no target between.
Filtered& edit(Filtered& filtered, const TriangleMesh& mesh) {
  const auto dab = [&](size_t vertex, double beta) {
    return Stroke{{.radius = 0.15 * filtered.diagonal(), .strength = 0.7, .beta = beta},
                  {mesh.vertices[vertex]}};
  };
  const auto dab_of_edges = [&](size_t vertex, double strength) {
    Stroke stroke = dab(vertex, strength);
    stroke.brush.edges = true;
    return stroke;
  };
  filtered.alpha(20).edges(machined(1)).beta(2).after(2);
  filtered.edges(machined(0.5)).after(1);
  filtered.beta(0.6).after(1);
  filtered.paint(dab(7, 2)).after(1);
  filtered.edges(machined(0.5, 0.4)).after(1);
  filtered.curve(TransferCurve::parse("-20:5,20:500").value()).after(1);
  filtered.edges(machined(0)).after(1);
  filtered.alpha(35).after(1);
  filtered.edges(machined(0.8, 0.4)).beta(1.5).after(1);
  filtered.paint(dab_of_edges(900, 0)).after(1);
  filtered.alpha(40).after(1);  // the same ratios
  filtered.paint(dab_of_edges(300, 1)).edges(machined(0.6, 0.4)).after(1);
  return filtered.paint(dab(1500, 0));
}

class KeptEdges : public testing::TestWithParam<BackendCase> {};

// Frames continue from the last constraint and an export does not, so both are compared.
TEST_P(KeptEdges, EndWhereTheProcessorsDo) {
  if (GetParam().options.smoother != Smoother::kSchwarz) return;
  const TriangleMesh mesh = noisy_part();
  Filtered here(mesh, kDepthOfPart, GetParam().options);
  Filtered there(mesh, kDepthOfPart, {.backend = BackendKind::kCpu});
  const std::vector<Vec3d> expected = edit(there, mesh).exact();
  EXPECT_LE(largest_distance(edit(here, mesh).settled(), expected, mesh), 1e-4);
  EXPECT_LE(largest_distance(here.exact(), expected, mesh), 2e-6);
  EXPECT_GT(largest_distance(expected, mesh.vertices, mesh), 1e-3);
}

TEST_P(KeptEdges, OfNoStrengthChangeNoBit) {
  const TriangleMesh mesh = noisy_part();
  Filtered plain(mesh, kDepthOfPart, GetParam().options),
      with(mesh, kDepthOfPart, GetParam().options);
  EXPECT_EQ(with.edges(machined(0)).alpha(20).beta(0.3).after(3),
            plain.alpha(20).beta(0.3).after(3));
}

INSTANTIATE_TEST_SUITE_P(Backends, KeptEdges, testing::ValuesIn(backend_cases()),
                         [](const auto& backend) { return backend.param.name; });

TEST_F(OnADevice, KeptEdgesGiveTheSameBitsTwice) {
  const TriangleMesh mesh = noisy_part();
  const auto run = [&] {
    Filtered filtered(mesh, kDepthOfPart, {.backend = BackendKind::kCuda, .devices = 1});
    return edit(filtered, mesh).exact();
  };
  EXPECT_EQ(run(), run());
}

TEST_F(OnADevice, KeptEdgesTakeMemoryThereWhileTheyAreOn) {
  Filtered filtered(noisy_part(), kDepthOfPart, {.backend = BackendKind::kCuda, .devices = 1});
  const uint64_t matrices = sizeof(TargetGradient) * filtered.session().prepared().cells.size();
  const Solver& solver = filtered.session().solver();
  // The first edits make room there that stays.
  filtered.alpha(20).beta(2).edges(machined(1)).settled();
  filtered.edges(machined(0)).settled();
  const uint64_t before = cuda_memory_used(), own = solver.byte_count();
  filtered.edges(machined(1)).settled();
  filtered.edges(machined(0.5)).settled();
  EXPECT_EQ(cuda_memory_used(), before + matrices);
  EXPECT_EQ(solver.byte_count(), own + matrices);
  filtered.edges(machined(0)).settled();
  EXPECT_EQ(cuda_memory_used(), before);
}

TEST_F(OnADevice, PaintedStrengthTakesFourBytesACellThere) {
  const TriangleMesh mesh = noisy_part();
  Filtered filtered(mesh, kDepthOfPart, {.backend = BackendKind::kCuda, .devices = 1});
  const Solver& solver = filtered.session().solver();
  filtered.alpha(20).beta(2).edges(machined(1)).settled();
  const uint64_t own = solver.byte_count();
  const Brush brush{.radius = 0.15 * filtered.diagonal(), .beta = 0, .edges = true};
  filtered.paint({brush, {mesh.vertices[7]}}).settled();
  EXPECT_EQ(solver.byte_count(), own + sizeof(float) * filtered.session().prepared().cells.size());
}

}  // namespace
}  // namespace burnish
