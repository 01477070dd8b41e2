// Built with CUDA only. A local new metric leaves the bits that a whole one makes.

#include <algorithm>
#include <map>
#include <utility>

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "server/fields/fields.h"
#include "server/prepare/prepare.h"
#include "server/solver/cuda/cuda_backend.h"
#include "server/solver/cuda/read_matrices.h"
#include "server/solver/tuning/plan_cycle.h"
#include "tests/backends/filtered.h"
#include "tests/backends/on_a_device.h"
#include "tests/reference/awkward_meshes.h"

namespace burnish {
namespace {

const Palette kPalette{{{"soft", 0xd04040, TransferCurve(400)},
                        {"edges", 0x4060d0, TransferCurve::parse("-20:10,0:80,20:400").value()}}};

TriangleMesh scan(const char* kind, uint64_t vertices) {
  return generate_scan({.kind = kind, .vertices = vertices}).value();
}

/// A scan, its fields, and a backend that takes one metric after the other.
class Painted {
 public:
  Painted(const TriangleMesh& mesh, int depth)
      : on_(make_multigrid(prepare(mesh, {.depth = depth}).value()).value()),
        fields_(*on_.prepared),
        backend_(make_cuda_backend(on_, Smoother::kSchwarz).value()) {
    fields_.set_palette(kPalette);
    take();
  }

  /// Paints a curve of the palette. `radius`: of the diagonal.
  void dab(size_t vertex, double radius, int curve, double strength = 0.7) {
    const Brush brush{.radius = radius * on_.prepared->statistics.diagonal(),
                      .strength = strength,
                      .curve = curve};
    fields_.paint({brush, {on_.prepared->vertices[vertex % on_.prepared->vertices.size()]}});
  }

  /// Brings the backend up to the fields. Returns whether all matrices are new.
  bool take() {
    const bool is_whole = backend_->set_metric(fields_.view().metric);
    backend_->set_constraint(fields_.view());
    EXPECT_TRUE(backend_->status().is_ok()) << backend_->status().message();
    return is_whole;
  }

  void expect_the_bits_of_a_whole_metric() {
    const auto whole = make_cuda_backend(on_, Smoother::kSchwarz).value();
    EXPECT_TRUE(whole->set_metric(fields_.view().metric));
    whole->set_constraint(fields_.view());
    const auto local = cuda::read_matrices(*backend_), all = cuda::read_matrices(*whole);
    ASSERT_EQ(local.size(), all.size());
    for (size_t i = 0; i < all.size(); ++i) {
      ASSERT_EQ(local[i].bits.size(), all[i].bits.size()) << all[i].name;
      size_t others = 0;
      for (size_t k = 0; k < all[i].bits.size(); ++k) others += local[i].bits[k] != all[i].bits[k];
      EXPECT_EQ(others, 0u) << all[i].name << ", of " << all[i].bits.size() << " words";
    }
  }

  Fields& fields() { return fields_; }

 private:
  Multigrid on_;
  Fields fields_;
  std::unique_ptr<Backend> backend_;
};

// A small dab, one that overlaps it, one elsewhere, one of another curve over both, and none.
void expect_local_dabs_are_whole(const TriangleMesh& mesh, int depth) {
  Painted painted(mesh, depth);
  size_t vertex = 7;
  constexpr std::pair<double, int> kDabs[] = {{0.05, 1}, {0.08, 1}, {0.03, 2}, {0.06, 2}};
  for (const auto& [radius, curve] : kDabs) {
    SCOPED_TRACE("dab of radius " + std::to_string(radius) + " at vertex " +
                 std::to_string(vertex));
    painted.dab(vertex, radius, curve);
    EXPECT_FALSE(painted.take());
    painted.expect_the_bits_of_a_whole_metric();
    vertex = vertex * 3 + 1000;
  }
  EXPECT_FALSE(painted.take());  // nothing is new
  painted.expect_the_bits_of_a_whole_metric();
}

TEST_F(OnADevice, LocalMetricsHaveTheBitsOfWholeOnes) {
  expect_local_dabs_are_whole(scan("blob", 20'000), 7);
}

// Rims, thin walls with ties, and corners with next to no surface.
TEST_F(OnADevice, LocalMetricsHaveTheBitsOfWholeOnesAtRims) {
  expect_local_dabs_are_whole(scan("tablet", 20'000), 7);
  expect_local_dabs_are_whole(scan("wall", 10'000), 6);
}

// Patches, all digits of S and M⁻¹, and sheets of components.
TEST_F(OnADevice, LocalMetricsHaveTheBitsOfWholeOnesWhereSheetsComeClose) {
  expect_local_dabs_are_whole(reference::small_components_over_a_sphere(), 5);
  expect_local_dabs_are_whole(reference::small_components_over_a_sphere(), 6);
  expect_local_dabs_are_whole(crossing_spheres(), 7);
  expect_local_dabs_are_whole(separate_pieces_and_a_tablet(), kDepthOfPieces);
}

TEST_F(OnADevice, LocalMetricsHaveTheBitsOfWholeOnesOnAwkwardScans) {
  for (const auto& [name, mesh] : reference::awkward_meshes()) {
    SCOPED_TRACE(name);
    Painted painted(mesh, 6);
    for (const size_t vertex : {5, 77}) {
      painted.dab(vertex, 0.02, 2);
      painted.take();
      painted.expect_the_bits_of_a_whole_metric();
    }
  }
}

// Small, for a sanitizer, which takes hundreds of times as long.
TEST_F(OnADevice, ALocalMetricOfASmallScanHasTheBitsOfAWholeOne) {
  for (const TriangleMesh& mesh :
       {scan("blob", 3000), reference::small_components_over_a_sphere()}) {
    Painted painted(mesh, 5);
    for (const int curve : {1, 2, 1}) {
      painted.dab(100 * curve, 0.05, curve);
      EXPECT_FALSE(painted.take());
    }
    painted.expect_the_bits_of_a_whole_metric();
  }
}

TEST_F(OnADevice, AnUndoneDabLeavesTheBitsFromBeforeIt) {
  Painted painted(scan("blob", 20'000), 7);
  painted.dab(7, 0.05, 1);
  painted.take();
  for (const int curve : {1, 2}) {
    const PaintedCells before = painted.fields().painted();
    painted.dab(9, 0.06, curve);
    EXPECT_FALSE(painted.take());
    painted.fields().set_painted(before);
    EXPECT_FALSE(painted.take());
    painted.expect_the_bits_of_a_whole_metric();
  }
}

TEST_F(OnADevice, AfterManyDabsOfAStrokeTheBitsAreThoseOfAWholeMetric) {
  Painted painted(scan("blob", 20'000), 7);
  for (size_t i = 0; i < 40; ++i) {
    painted.dab(100 * i, 0.04, 1 + static_cast<int>(i % 3 == 0), 0.3);
    painted.take();
  }
  painted.expect_the_bits_of_a_whole_metric();
}

TEST_F(OnADevice, PaintOnMostCellsAndAnotherCurveMakeAllMatricesAnew) {
  Painted painted(scan("blob", 20'000), 7);
  painted.dab(7, 2, 1);
  EXPECT_TRUE(painted.take());
  painted.dab(7, 0.05, 2);
  EXPECT_FALSE(painted.take());
  painted.fields().set_transfer_curve(TransferCurve(20));
  EXPECT_TRUE(painted.take());
  painted.dab(4000, 0.05, 2);
  EXPECT_FALSE(painted.take());
  painted.expect_the_bits_of_a_whole_metric();
}

// The curve of cells without paint has contrast too, so the largest ratio is looked for among all.
TEST_F(OnADevice, BesideACurveOfContrastLocalMetricsHaveTheBitsOfWholeOnes) {
  Painted painted(scan("blob", 20'000), 7);
  painted.fields().set_transfer_curve(TransferCurve::parse("-20:5,20:500").value());
  painted.take();
  for (const int curve : {1, 2, 1}) {
    painted.dab(1000 * curve, 0.06, curve);
    EXPECT_FALSE(painted.take());
    painted.expect_the_bits_of_a_whole_metric();
  }
}

Stroke curve_stroke(const Filtered& on, const Vec3d& at, int curve) {
  Stroke stroke{{.radius = 0.05 * on.diagonal(), .strength = 0.7}, {at}};
  stroke.brush.curve = curve;
  return stroke;
}

/// Returns the vertices after some cycles, or once settled, behind dabs with a cycle each.
std::vector<Vec3d> after_dabs(const TriangleMesh& mesh, BackendKind backend, int cycles) {
  Filtered filtered(mesh, 7, {.backend = backend});
  filtered.palette(kPalette).beta(0).after(5);
  for (size_t i = 0; i < 6; ++i)
    filtered.paint(curve_stroke(filtered, mesh.vertices[900 * i], 1 + static_cast<int>(i % 2)))
        .after(1);
  EXPECT_TRUE(filtered.session().apply({"undo", Undo{}}).is_ok());
  return cycles > 0 ? filtered.after(cycles) : filtered.settled();
}

TEST_F(OnADevice, AfterLocalMetricsItFollowsTheCpuCycleByCycle) {
  for (const char* kind : {"blob", "tablet", "sheets"}) {
    const TriangleMesh mesh = scan(kind, 20'000);
    for (const int cycles : {1, 3}) {
      SCOPED_TRACE(std::string(kind) + " after " + std::to_string(cycles) + " cycles");
      EXPECT_LE(largest_distance(after_dabs(mesh, BackendKind::kCpu, cycles),
                                 after_dabs(mesh, BackendKind::kCuda, cycles), mesh),
                3e-4);
    }
    EXPECT_LE(largest_distance(after_dabs(mesh, BackendKind::kCpu, 0),
                               after_dabs(mesh, BackendKind::kCuda, 0), mesh),
              5e-4)
        << kind;
  }
}

TEST_F(OnADevice, TwoRunsOfLocalMetricsGiveTheSameBits) {
  const TriangleMesh mesh = scan("blob", 20'000);
  EXPECT_EQ(after_dabs(mesh, BackendKind::kCuda, 3), after_dabs(mesh, BackendKind::kCuda, 3));
}

TEST_F(OnADevice, SessionsOfOneMeshPaintWithoutEachOther) {
  const TriangleMesh mesh = scan("blob", 20'000);
  const auto multigrid = make_multigrid(prepare(mesh, {.depth = 7}).value()).value();
  const auto open = [&] {
    auto session = Session::open(multigrid, {.backend = BackendKind::kCuda}).value();
    EXPECT_TRUE(session->apply({"palette", SetPalette{kPalette}}).is_ok());
    EXPECT_TRUE(session->apply({"beta", SetGradientScale{0}}).is_ok());
    session->step();
    return session;
  };
  const auto paint = [&](Session& session, size_t vertex) {
    Stroke stroke{{.radius = 0.05 * multigrid.prepared->statistics.diagonal()},
                  {mesh.vertices[vertex]}};
    stroke.brush.curve = 1;
    EXPECT_TRUE(session.apply({std::to_string(vertex), stroke}).is_ok());
    session.step();
  };
  const auto one = open(), other = open(), alone = open();
  for (size_t i = 0; i < 4; ++i) {
    paint(*one, 500 * i);
    paint(*other, 9000 + 500 * i);
  }
  for (size_t i = 0; i < 4; ++i) paint(*alone, 500 * i);
  EXPECT_EQ(one->surface().vertices, alone->surface().vertices);
  EXPECT_NE(one->surface().vertices, other->surface().vertices);
}

}  // namespace
}  // namespace burnish
