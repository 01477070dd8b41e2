#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/edit/wavelength.h"
#include "common/generate/generate.h"
#include "common/mesh/statistics/statistics.h"
#include "tests/server/session/solved_session.h"

namespace burnish {
namespace {

using testing::HasSubstr;

std::unique_ptr<Session> controlled(const TriangleMesh& mesh, const Controls& controls) {
  return session_over(mesh, 5, controls);
}

const SetTransferCurve kBroad{TransferCurve(10)};
const SetGradientScale kSmoothAll{0};

TEST(Controls, PinnedRimsDoNotMoveAtAllAndTheInsideDoes) {
  const TriangleMesh sheet = make_sheet(40, 1, 0.1);
  const auto moved = exact_surface(*controlled(sheet, {.pin_rims = true}), {kBroad, kSmoothAll});
  const auto free = exact_surface(*controlled(sheet, {}), {kBroad, kSmoothAll});
  double rim_free = 0;
  for (size_t v = 0; v < sheet.vertices.size(); ++v) {
    const Vec3d& p = sheet.vertices[v];
    if (p.x() != 0 && p.y() != 0 && p.x() != 1 && p.y() != 1) continue;
    EXPECT_EQ(moved.vertices[v], p);
    rim_free = std::max(rim_free, (free.vertices[v] - p).norm());
  }
  EXPECT_GT(rim_free, 0.05);
  const size_t top = 20 * 41 + 20;
  EXPECT_LT(moved.vertices[top].z(), 0.6 * sheet.vertices[top].z());
}

TEST(Controls, NextToAPinnedRimTheSurfaceHasNoStep) {
  const TriangleMesh sheet = make_sheet(60, 1, 0);
  const auto session = controlled(sheet, {.pin_rims = true});
  const auto moved = exact_surface(*session, {kBroad, kSmoothAll});
  EXPECT_LT(farthest(moved, sheet), 0.1 * session->prepared().frame.cell_size);
}

TEST(Controls, NothingMovesMoreThanTheCap) {
  const TriangleMesh sheet = make_sheet(40, 1, 0.1);
  const Controls capped{.cap = 0.01};
  const auto moved = exact_surface(*controlled(sheet, capped), {kBroad, kSmoothAll});
  const double diagonal = compute_statistics(sheet).diagonal();
  EXPECT_LE(farthest(moved, sheet), capped.cap + 1e-6 * diagonal);
  EXPECT_GT(farthest(moved, sheet), 0.99 * capped.cap);
}

TEST(Controls, AClosedScanKeepsItsVolume) {
  const TriangleMesh sphere = make_icosphere(4, 1);
  const auto volume = [](const TriangleMesh& mesh) {
    return compute_statistics(mesh).signed_volume;
  };
  const auto free = exact_surface(*controlled(sphere, {}), {kBroad, kSmoothAll});
  const auto kept = exact_surface(*controlled(sphere, {.keep_volume = true}), {kBroad, kSmoothAll});
  EXPECT_LT(volume(free), 0.9 * volume(sphere));
  EXPECT_NEAR(volume(kept) / volume(sphere), 1, 1e-6);
}

double volume_of(const TriangleMesh& mesh) {
  return compute_statistics(mesh).signed_volume;
}

TEST(Controls, TheVolumeIsKeptHoweverStronglyAScanIsSmoothed) {
  for (const TriangleMesh& scan : {make_icosphere(3, 1), lumpy_scan()}) {
    const auto session = controlled(scan, {.keep_volume = true});
    for (const double alpha : {1, 2, 3, 5, 6, 8, 20, 50, 500}) {
      const auto kept =
          exact_surface(*session, {SetTransferCurve{TransferCurve(alpha)}, kSmoothAll});
      EXPECT_NEAR(volume_of(kept) / volume_of(scan), 1, 1e-6) << alpha;
      EXPECT_NEAR(session->kept_volume().value(), 1, 1e-9) << alpha;
    }
  }
}

TEST(Controls, ACollapsedSphereGrowsBackToASphere) {
  const TriangleMesh sphere = make_icosphere(4, 1);
  const auto session = controlled(sphere, {.keep_volume = true});
  const auto kept = exact_surface(*session, {SetTransferCurve{TransferCurve(2)}, kSmoothAll});
  EXPECT_LT(farthest(kept, sphere), 0.02);
}

TEST(Controls, PiecesGrowBackWhereTheyAre) {
  TriangleMesh two = make_icosphere(3, 1);
  const size_t of_one = two.vertices.size(), triangles = two.triangles.size();
  for (size_t v = 0; v < of_one; ++v) two.vertices.push_back(two.vertices[v] + Vec3d(4, 0, 0));
  for (size_t t = 0; t < triangles; ++t) {
    Triangle other = two.triangles[t];
    for (uint32_t& v : other) v += static_cast<uint32_t>(of_one);
    two.triangles.push_back(other);
  }
  const auto session = controlled(two, {.keep_volume = true});
  const auto kept = exact_surface(*session, {SetTransferCurve{TransferCurve(3)}, kSmoothAll});
  EXPECT_LT(farthest(kept, two), 0.05);
}

TEST(Controls, ASliderNeverMakesTheKeptSurfaceJump) {
  const TriangleMesh scan = lumpy_scan();
  const auto session = controlled(scan, {.keep_volume = true});
  const double diagonal = compute_statistics(scan).diagonal();
  TriangleMesh last;
  for (double alpha = 12; alpha > 2; alpha *= 0.93) {
    const auto now = exact_surface(*session, {SetTransferCurve{TransferCurve(alpha)}, kSmoothAll});
    EXPECT_NEAR(volume_of(now) / volume_of(scan), 1, 1e-6) << alpha;
    if (!last.vertices.empty()) {
      EXPECT_LT(farthest(now, last), 0.03 * diagonal) << alpha;
    }
    last = now;
  }
}

TEST(Controls, AScanThatIsInsideOutKeepsItsVolumeToo) {
  TriangleMesh sphere = make_icosphere(3, 1);
  for (Triangle& triangle : sphere.triangles) std::swap(triangle[0], triangle[1]);
  ASSERT_LT(volume_of(sphere), 0);
  for (const double alpha : {3, 10}) {
    const auto session = controlled(sphere, {.keep_volume = true});
    const auto kept = exact_surface(*session, {SetTransferCurve{TransferCurve(alpha)}, kSmoothAll});
    EXPECT_NEAR(volume_of(kept) / volume_of(sphere), 1, 1e-6) << alpha;
    EXPECT_LT(farthest(kept, sphere), 0.1) << alpha;
  }
}

TEST(Controls, AStrongStrokeKeepsTheVolume) {
  const TriangleMesh scan = generate_scan({"blob", 20000, 1}).value();
  const Vec3d top =
      *std::ranges::max_element(scan.vertices, {}, [](const Vec3d& p) { return p.z(); });
  const double reach = 0.2 * compute_statistics(scan).diagonal() / std::sqrt(3);
  const Stroke stroke{{reach, 1, 0, FallOff::kSmooth}, {top}};
  const auto free =
      exact_surface(*session_over(scan, 6), {SetTransferCurve{TransferCurve(5)}, stroke});
  const auto session = session_over(scan, 6, {.keep_volume = true});
  const auto kept = exact_surface(*session, {SetTransferCurve{TransferCurve(5)}, stroke});
  EXPECT_LT(volume_of(free), 0.995 * volume_of(scan));
  EXPECT_NEAR(volume_of(kept) / volume_of(scan), 1, 1e-6);
}

TEST(Controls, AVolumeIsKeptWithinTheCap) {
  for (const TriangleMesh& scan : {make_icosphere(4, 1), lumpy_scan()})
    for (const double cap : {0.001, 0.05}) {
      const auto session = controlled(scan, {.cap = cap, .keep_volume = true});
      for (const double alpha : {5, 50})
        for (const double beta : {0, 3}) {
          const auto kept = exact_surface(
              *session, {SetTransferCurve{TransferCurve(alpha)}, SetGradientScale{beta}});
          EXPECT_LE(farthest(kept, scan), cap + 1e-6) << alpha;
          EXPECT_NEAR(volume_of(kept) / volume_of(scan), 1, 1e-6) << cap << " " << alpha;
          EXPECT_NEAR(session->kept_volume().value(), 1, 1e-6) << cap << " " << alpha;
        }
    }
}

TEST(Controls, AVolumeIsKeptBesideAProtectedPart) {
  const TriangleMesh scan = lumpy_scan();
  const auto session = controlled(scan, {.keep_volume = true});
  LassoRegion half;
  half.view_projection = {1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1};  // y is the height
  half.polygon = {{-9, 0}, {9, 0}, {9, 9}, {-9, 9}};
  half.through = true;
  const auto kept =
      exact_surface(*session, {Protect{half}, SetTransferCurve{TransferCurve(10)}, kSmoothAll});
  EXPECT_TRUE(session->fields().hold());
  EXPECT_NEAR(volume_of(kept) / volume_of(scan), 1, 1e-6);
}

/// A part that may move and the tail around it, which loses more than the part can give.
TEST(Controls, AVolumeThatTheCapTakesIsTold) {
  const TriangleMesh scan = lumpy_scan();
  const Controls controls{.cap = 0.02, .keep_volume = true};
  const auto session = controlled(scan, controls);
  EXPECT_EQ(session->kept_volume(), std::nullopt);
  const Stroke spot{{0.1, 1, 0, FallOff::kSmooth}, {scan.vertices[0]}};
  const auto kept = exact_surface(*session, {SetTransferCurve{TransferCurve(2)}, spot});
  const double left = volume_of(kept) / volume_of(scan);
  EXPECT_GT(std::abs(left - 1), 1e-5);
  EXPECT_NEAR(session->kept_volume().value(), left, 1e-6);
  EXPECT_THAT(lost_volume_text(left, controls), HasSubstr("largest move"));
  EXPECT_EQ(lost_volume_text(1 + 1e-9, controls), "");
  exact_surface(*session, {SetControls{{.cap = 0.02}}});
  EXPECT_EQ(session->kept_volume(), std::nullopt);
}

TEST(Controls, AScanThatShrinksToAPointDoesNotGrowBackAndThatIsTold) {
  const Controls controls{.keep_volume = true};
  const auto session = controlled(make_icosphere(3, 1), controls);
  exact_surface(*session, {SetTransferCurve{TransferCurve(0.05)}, kSmoothAll});
  const double left = session->kept_volume().value();
  EXPECT_LT(left, 0.5);
  EXPECT_THAT(lost_volume_text(left, controls), HasSubstr("cannot grow"));
}

TEST(Controls, KeepingTheVolumeMovesNothingThatNoEditReaches) {
  const TriangleMesh sphere = make_icosphere(4, 1);
  const Stroke stroke{{0.4, 1, 0, FallOff::kSmooth}, {Vec3d(0, 0, 1)}};
  const auto free = exact_surface(*controlled(sphere, {}), {stroke});
  const auto kept = exact_surface(*controlled(sphere, {.keep_volume = true}), {stroke});
  for (size_t v = 0; v < sphere.vertices.size(); ++v)
    if (sphere.vertices[v].z() < 0) {
      EXPECT_LT((kept.vertices[v] - free.vertices[v]).norm(), 1e-7);
    }
  EXPECT_NEAR(compute_statistics(kept).signed_volume / compute_statistics(sphere).signed_volume, 1,
              1e-6);
}

TEST(Controls, ReturnTheScanExactlyWhereBetaIsOne) {
  const Controls all{.pin_rims = true, .cap = 0.1};
  const TriangleMesh sheet = make_sheet(20, 1, 0.1);
  EXPECT_EQ(exact_surface(*controlled(sheet, all), {kBroad}).vertices, sheet.vertices);
  const TriangleMesh sphere = make_icosphere(3, 1);
  EXPECT_EQ(exact_surface(*controlled(sphere, {.keep_volume = true}), {kBroad}).vertices,
            sphere.vertices);
}

TEST(Controls, AreEditsThatUndoTakesBackToThoseOfTheBirth) {
  const auto session = controlled(make_sheet(20, 1, 0.1), {.pin_rims = true});
  EXPECT_TRUE(session->fields().rims());
  ASSERT_TRUE(session->apply({"1", SetControls{{.cap = 2}}}).is_ok());
  EXPECT_FALSE(session->fields().rims());
  EXPECT_EQ(session->edited().controls(), (Controls{.cap = 2}));
  ASSERT_TRUE(session->apply({"2", Undo{}}).is_ok());
  EXPECT_TRUE(session->fields().rims());
  EXPECT_EQ(session->edited().controls(), (Controls{.pin_rims = true}));
}

// Frames and pictures have places on a lattice of some thousandths of a cell.
TEST(Controls, OnAFlatFreeSheetAVertexMovesAsThePlaceThatItIsRoundedTo) {
  constexpr float kRounding = 1e-3F, kCells = 1 / 16.F;
  const TriangleMesh sheet = make_sheet(54, 1, 0.1);
  const auto prepared = *prepare(sheet, PrepareOptions{.depth = 5});
  const Multigrid on = make_multigrid(prepared).value();
  const auto session = Session::open(on, {.backend = BackendKind::kCpu}, {}).value();
  exact_surface(*session, {SetGradientScale{0.3}});
  const SparseGrid& grid = on.hierarchy->at(on.hierarchy->finest).grid;
  const auto displacement = session->displacement();
  float most = 0;
  for (EvaluationPoint point : prepared->evaluation) {
    const Vec3f here = evaluate(grid, point, displacement);
    point.local[2] += point.local[2] < 0.5F ? kRounding : -kRounding;
    most = std::max(most, (evaluate(grid, point, displacement) - here).norm());
  }
  EXPECT_LT(most, kCells);
}

TEST(Controls, TellOfRimsThoughNoneIsHeld) {
  const TriangleMesh soup = generate_scan({"soup", 3000, 1}).value();
  const auto session = controlled(soup, {.pin_rims = true});
  EXPECT_FALSE(session->fields().rims());
  ASSERT_TRUE(session->edited().pinned_rims());
  EXPECT_GT(session->edited().pinned_rims()->rims, 0u);
  EXPECT_EQ(session->edited().pinned_rims()->held, 0u);
  EXPECT_THAT(describe(*session->edited().pinned_rims()), HasSubstr("none of"));
  ASSERT_TRUE(session->apply({"1", SetControls{{.pin_rims = false}}}).is_ok());
  EXPECT_FALSE(session->edited().pinned_rims());
}

TEST(Controls, RefuseAVolumeOfAScanThatIsNotClosed) {
  const auto session = controlled(make_sheet(20, 1, 0.1), {});
  const Status status = session->edited().check_new({"1", SetControls{{.keep_volume = true}}});
  EXPECT_EQ(status.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(status.message(), HasSubstr("not closed"));
}

/// A sphere beside one that is inside out and has this radius.
TriangleMesh sphere_and_hollow(double radius) {
  TriangleMesh two = make_icosphere(3, 1);
  const TriangleMesh hollow = make_icosphere(3, radius);
  const auto of_one = static_cast<uint32_t>(two.vertices.size());
  for (const Vec3d& v : hollow.vertices) two.vertices.push_back(v + Vec3d(4, 0, 0));
  for (const Triangle& t : hollow.triangles)
    two.triangles.push_back({t[1] + of_one, t[0] + of_one, t[2] + of_one});
  return two;
}

TEST(Controls, AVolumeOfNothingCannotBeKept) {
  const Controls keep{.keep_volume = true};
  for (const double radius : {1.0, 1 + 1e-7}) {
    const auto session = controlled(sphere_and_hollow(radius), {});
    const Status status = session->edited().check_new({"1", SetControls{keep}});
    EXPECT_EQ(status.code(), StatusCode::kFailedPrecondition);
    EXPECT_THAT(status.message(), HasSubstr("must be at least 0.000"));
    EXPECT_THAT(status.message(), HasSubstr("inside out"));
  }
  const auto session = controlled(sphere_and_hollow(0.9), {});
  EXPECT_TRUE(session->edited().check_new({"1", SetControls{keep}}).is_ok());
}

TEST(Controls, AProtectedRegionDoesNotMoveWhateverIsEdited) {
  const TriangleMesh sphere = make_icosphere(4, 1);
  const auto session = controlled(sphere, {});
  LassoRegion top;  // seen from above: x to the right, y upwards, z towards the viewer
  top.view_projection = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -0.1, 0, 0, 0, 0, 1};
  top.polygon = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  const Stroke stroke{{0.4, 1, 4, FallOff::kSmooth}, {Vec3d(0, 0, 1)}};
  const auto moved = exact_surface(*session, {kBroad, kSmoothAll, Protect{top}, stroke});
  for (size_t v = 0; v < sphere.vertices.size(); ++v) {
    const Vec3d& p = sphere.vertices[v];
    const double inside = 0.5 - std::max(std::abs(p.x()), std::abs(p.y()));
    const double cell = session->prepared().frame.cell_size;
    if (p.z() > 0 && inside > cell) {
      EXPECT_EQ(moved.vertices[v], p);
    }
    if (p.z() < -0.5) {
      EXPECT_GT((moved.vertices[v] - p).norm(), 0.01);
    }
  }
  ASSERT_TRUE(session->apply({"u1", Undo{}}).is_ok());
  ASSERT_TRUE(session->apply({"u2", Undo{}}).is_ok());
  EXPECT_FALSE(session->fields().hold());
}

TEST(Controls, RimsStayPinnedBesideAProtectedRegion) {
  const auto session = controlled(make_sheet(40, 1, 0.1), {.pin_rims = true});
  const auto rims = session->fields().rims();
  ASSERT_TRUE(rims);
  ASSERT_TRUE(session->apply({"1", Protect{PieceRegion{Vec3d(0.5, 0.5, 0)}}}).is_ok());
  EXPECT_EQ(session->fields().hold()->cells.size(), session->prepared().cells.size());
  EXPECT_EQ(session->fields().rims(), rims);
  ASSERT_TRUE(session->apply({"2", Protect{NoRegion{}}}).is_ok());
  EXPECT_FALSE(session->fields().hold());
  EXPECT_EQ(session->fields().rims(), rims);
}

TEST(Wavelength, AWaveOfAlphasLengthIsHalvedByBetaZero) {
  constexpr double kWave = 0.25, kHeight = 1e-3;
  TriangleMesh sheet = make_sheet(80, 1, 0);
  for (Vec3d& p : sheet.vertices) p.z() = kHeight * std::cos(2 * std::numbers::pi * p.x() / kWave);
  const auto session = controlled(sheet, {});
  const double alpha = alpha_of_wavelength(session->prepared().length_unit, kWave);
  const auto moved = exact_surface(*session, {SetTransferCurve{TransferCurve(alpha)}, kSmoothAll});
  const size_t crest = 40 * 81 + 40;  // x = y = 0.5
  ASSERT_NEAR(sheet.vertices[crest].z(), kHeight, 1e-12);
  EXPECT_NEAR(moved.vertices[crest].z() / kHeight, 0.5, 0.02);
}

}  // namespace
}  // namespace burnish
