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

const Equaliser kThreeBands{{{0.3, 1}, {0.8, 1}, {2, 1}}};

Equaliser with_gains(Equaliser equaliser, const std::vector<double>& gains) {
  for (size_t i = 0; i < gains.size(); ++i) equaliser.bands[i].gain = gains[i];
  return equaliser;
}

double mean_radius(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Vec3d& vertex : mesh.vertices) sum += vertex.norm();
  return sum / static_cast<double>(mesh.vertices.size());
}

TEST(Equaliser, GainsOfOneReturnTheScanExactly) {
  const TriangleMesh blob = lumpy_scan();
  const auto session = session_over(blob);
  EXPECT_EQ(exact_surface(*session, {SetEqualiser{kThreeBands}}).vertices, blob.vertices);
}

TEST(Equaliser, GainsOfNoughtLeaveTheSurfaceBehindTheLastBand) {
  const TriangleMesh blob = lumpy_scan();
  const auto bands = session_over(blob), smooth = session_over(blob);
  const double alpha = alpha_of_wavelength(bands->prepared().length_unit, 2);
  const auto silent = exact_surface(*bands, {SetEqualiser{with_gains(kThreeBands, {0, 0, 0})}});
  const auto smoothed =
      exact_surface(*smooth, {SetTransferCurve{TransferCurve(alpha)}, SetGradientScale{0}});
  EXPECT_LT(farthest(silent, smoothed), 1e-6 * compute_statistics(blob).diagonal());
  EXPECT_GT(farthest(silent, blob), 1e-2 * compute_statistics(blob).diagonal());
}

TEST(Equaliser, OneGainForAllBandsScalesWhatSmoothingTakes) {
  const TriangleMesh blob = lumpy_scan();
  const auto session = session_over(blob);
  const auto none = exact_surface(*session, {SetEqualiser{with_gains(kThreeBands, {0, 0, 0})}});
  const auto twice = exact_surface(*session, {SetEqualiser{with_gains(kThreeBands, {2, 2, 2})}});
  for (size_t v = 0; v < blob.vertices.size(); ++v) {
    const Vec3d expected = 2 * blob.vertices[v] - none.vertices[v];
    ASSERT_LT((twice.vertices[v] - expected).norm(), 1e-6 * compute_statistics(blob).diagonal());
  }
}

// The coordinates of a sphere of radius 1 are harmonics of order 1: λ² = 2.
TEST(Equaliser, EachBandOfASphereAnswersAsTheFormulaSays) {
  const TriangleMesh sphere = make_icosphere(5, 1);
  const Equaliser bands{{{2, 1}, {4, 1}, {8, 1}}};
  const auto kept_behind = [](double size) {
    const double a = 2 * std::numbers::pi / size;
    return a * a / (a * a + 2);
  };
  const auto session = session_over(sphere, 6);
  double before = 1;
  for (size_t band = 0; band < bands.bands.size(); ++band) {
    std::vector<double> gains(bands.bands.size(), 1);
    gains[band] = 0;
    const auto without = exact_surface(*session, {SetEqualiser{with_gains(bands, gains)}});
    const double behind = kept_behind(bands.bands[band].size);
    EXPECT_NEAR(mean_radius(without), 1 - (before - behind), 1e-3);
    before = behind;
  }
}

TEST(Equaliser, ExactResultsFollowFromTheEditsAlone) {
  const TriangleMesh blob = lumpy_scan();
  const Equaliser equaliser = with_gains(kThreeBands, {0.5, 2, 1.5});
  const auto live = session_over(blob), at_once = session_over(blob);
  exact_surface(*live, {SetEqualiser{Equaliser{{{0.4, 1}, {2, 0}}}}});
  EXPECT_TRUE(live->apply({"bands", SetEqualiser{equaliser}}).is_ok());
  for (int i = 0; i < 30; ++i) live->step();
  EXPECT_EQ(exact_surface(*live, {}).vertices,
            exact_surface(*at_once, {SetEqualiser{equaliser}}).vertices);
}

TEST(Equaliser, AGainCostsNoCycle) {
  const auto session = session_over(lumpy_scan());
  exact_surface(*session, {SetEqualiser{kThreeBands}});
  const StepReport last = session->step();
  const std::vector<Vec3f> before(session->displacement().begin(), session->displacement().end());
  const uint64_t surface_revision = session->surface_revision();
  ASSERT_TRUE(session->apply({"gain", SetEqualiser{with_gains(kThreeBands, {2})}}).is_ok());
  session->update();
  EXPECT_TRUE(session->is_settled(last));
  EXPECT_GT(session->surface_revision(), surface_revision);
  EXPECT_FALSE(std::ranges::equal(session->displacement(), before));
}

TEST(Equaliser, AnotherSizeSolvesThatBandAlone) {
  const auto session = session_over(lumpy_scan());
  exact_surface(*session, {SetEqualiser{with_gains(kThreeBands, {2})}});
  Equaliser wider = with_gains(kThreeBands, {2});
  wider.bands[2].size = 3;
  ASSERT_TRUE(session->apply({"wider", SetEqualiser{wider}}).is_ok());
  session->update();
  const auto at_once = session->displacement();
  EXPECT_FALSE(session->is_settled({}));
  EXPECT_GT(std::ranges::max(at_once, {}, &Vec3f::norm).norm(), 0);  // the fine bands are there
}

TEST(Equaliser, APaintedGainCountsUnderTheBrushOnly) {
  const TriangleMesh sphere = make_icosphere(4, 1);
  const auto session = session_over(sphere);
  const Equaliser band{{{4, 1}}};
  Stroke stroke{{0.5, 1, 0, FallOff::kConstant}, {Vec3d(0, 0, 1)}};
  stroke.brush.band = 1;
  const auto painted = exact_surface(*session, {SetEqualiser{band}, stroke});
  const auto all = exact_surface(*session_over(sphere), {SetEqualiser{with_gains(band, {0})}});
  for (size_t v = 0; v < sphere.vertices.size(); ++v) {
    const Vec3d& p = sphere.vertices[v];
    if (p.z() < 0) {
      ASSERT_EQ(painted.vertices[v], p);
    }
    if (p.z() > 0.98) {
      ASSERT_LT((painted.vertices[v] - all.vertices[v]).norm(), 1e-6);
    }
  }
}

TEST(Equaliser, PinnedRimsStayAndItsVolumeIsKept) {
  const TriangleMesh sheet = make_sheet(40, 1, 0.1), sphere = make_icosphere(4, 1);
  const SetEqualiser silent{Equaliser{{{1, 0}}}};
  const auto pinned = exact_surface(*session_over(sheet, 5, {.pin_rims = true}), {silent});
  for (size_t v = 0; v < sheet.vertices.size(); ++v) {
    const Vec3d& p = sheet.vertices[v];
    if (p.x() == 0 || p.y() == 0 || p.x() == 1 || p.y() == 1) {
      ASSERT_EQ(pinned.vertices[v], p);
    }
  }
  const auto kept = exact_surface(*session_over(sphere, 5, {.keep_volume = true}), {silent});
  EXPECT_NEAR(compute_statistics(kept).signed_volume / compute_statistics(sphere).signed_volume, 1,
              1e-6);
}

TEST(Equaliser, StandsBesideTheGradientScale) {
  const TriangleMesh blob = lumpy_scan();
  const SetEqualiser louder{with_gains(kThreeBands, {2, 1, 1})};
  const auto beta = exact_surface(*session_over(blob), {SetGradientScale{0.5}});
  const auto bands = exact_surface(*session_over(blob), {louder});
  const auto both = exact_surface(*session_over(blob), {SetGradientScale{0.5}, louder});
  for (size_t v = 0; v < blob.vertices.size(); ++v) {
    const Vec3d expected = beta.vertices[v] + bands.vertices[v] - blob.vertices[v];
    ASSERT_LT((both.vertices[v] - expected).norm(), 2e-6 * compute_statistics(blob).diagonal());
  }
}

TEST(Equaliser, UndoTakesAGainAndItsPaintBack) {
  const TriangleMesh blob = lumpy_scan();
  const auto session = session_over(blob);
  Stroke stroke{{0.5, 1, 3, FallOff::kSmooth}, {blob.vertices[0]}};
  stroke.brush.band = 2;
  exact_surface(*session, {SetEqualiser{kThreeBands}, stroke});
  EXPECT_TRUE(session->fields().gain_paint(2));
  EXPECT_EQ(exact_surface(*session, {Undo{}}).vertices, blob.vertices);
  EXPECT_FALSE(session->fields().gain_paint(2));
  exact_surface(*session, {Undo{}});
  EXPECT_TRUE(session->fields().equaliser().bands.empty());
}

TEST(Equaliser, RefusesABrushOfABandThatItLacks) {
  const auto session = session_over(make_icosphere(3, 1));
  Stroke stroke{{0.5, 1, 3, FallOff::kSmooth}, {Vec3d(0, 0, 1)}};
  stroke.brush.band = 4;
  const Status status = session->edited().layers().take({"1", stroke});
  EXPECT_EQ(status.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(status.message(), HasSubstr("band 4"));
}

TEST(Equaliser, ABrushMayPaintABandThatAnEarlierEditOfItsMessageSets) {
  const auto session = session_over(make_icosphere(3, 1));
  Stroke stroke{{0.5, 1, 3, FallOff::kSmooth}, {Vec3d(0, 0, 1)}};
  stroke.brush.band = 3;
  LayerCheck layers = session->edited().layers();
  EXPECT_TRUE(layers.take({"1", SetEqualiser{kThreeBands}}).is_ok());
  EXPECT_TRUE(layers.take({"2", stroke}).is_ok());
  EXPECT_TRUE(layers.take({"3", SetEqualiser{}}).is_ok());
  EXPECT_FALSE(layers.take({"4", stroke}).is_ok());
}

}  // namespace
}  // namespace burnish
