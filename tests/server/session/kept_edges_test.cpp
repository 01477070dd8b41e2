#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/edit/wavelength.h"
#include "common/generate/generate.h"
#include "common/mesh/statistics/statistics.h"
#include "server/session/edge_parts.h"
#include "tests/common/denoise/shape_error.h"
#include "tests/server/session/solved_session.h"

namespace burnish {
namespace {

using testing::HasSubstr;

/// A part and the same with a scanner's noise.
struct NoisyPart {
  TriangleMesh clean = *generate_scan({"part", 2500, 1, 0.0});
  TriangleMesh noisy = *generate_scan({"part", 2500, 1, 0.2, *parse_noise_kind("gauss")});

  SetTransferCurve waves() const { return waves(noisy); }
  /// Returns the same wavelength for a mesh of another area.
  SetTransferCurve waves(const TriangleMesh& mesh) const {
    const double wavelength = kEdgeWaveEdges * compute_statistics(noisy).mean_edge_length;
    const double area = compute_statistics(mesh).area;
    return {TransferCurve(alpha_of_wavelength(std::sqrt(area), wavelength))};
  }
  TriangleMesh filtered(const std::vector<Change>& changes) const {
    return exact_surface(*session_over(noisy, 6), changes);
  }
};

SetEdges machined() {
  return {find_edge_preset("machined")->filter};
}

SetEdges at_strength(double strength) {
  SetEdges edges = machined();
  edges.filter.strength = strength;
  return edges;
}

TEST(KeptEdges, NoiseGoesAndEdgesStay) {
  const NoisyPart part;
  const TriangleMesh kept = part.filtered({part.waves(), machined()});
  const TriangleMesh smoothed = part.filtered({part.waves(), SetGradientScale{0}});
  const double noise = shape_error(part.clean, part.noisy).angle;
  EXPECT_GT(noise, 15);
  EXPECT_LT(shape_error(part.clean, kept).angle, 0.25 * noise);
  EXPECT_LT(shape_error(part.clean, kept).angle, 0.5 * shape_error(part.clean, smoothed).angle);
  EXPECT_EQ(turned_share(part.noisy, kept), 0);
}

TEST(KeptEdges, SharpeningLeavesTheNoiseAlone) {
  const NoisyPart part;
  const SetGradientScale sharper{3};
  const auto sharp = exact_surface(*session_over(part.clean, 6), {part.waves(), sharper});
  const TriangleMesh kept = part.filtered({part.waves(), machined(), sharper});
  const TriangleMesh plain = part.filtered({part.waves(), sharper});
  EXPECT_LT(shape_error(sharp, kept).angle, 0.3 * shape_error(sharp, plain).angle);
}

TEST(KeptEdges, AtNoStrengthExportsAreBitForBitThoseWithout) {
  const NoisyPart part;
  const SetGradientScale smoother{0.5};
  const TriangleMesh without = part.filtered({part.waves(), smoother});
  EXPECT_EQ(part.filtered({part.waves(), smoother, at_strength(0)}).vertices, without.vertices);
  const TriangleMesh back = part.filtered({part.waves(), machined(), smoother, at_strength(0)});
  EXPECT_EQ(back.vertices, without.vertices);
}

TEST(KeptEdges, ExportsDependOnTheLastFilterAlone) {
  const NoisyPart part;
  const TriangleMesh direct = part.filtered({part.waves(), at_strength(0.5)});
  SetEdges other = machined();
  other.filter.passes = 3;
  other.filter.crispness = 0.25;
  const auto session = session_over(part.noisy, 6);
  exact_surface(*session, {part.waves(), other});
  EXPECT_EQ(exact_surface(*session, {at_strength(0.5)}).vertices, direct.vertices);
}

TEST(KeptEdges, StepsLeadToWhatASolveFinds) {
  const NoisyPart part;
  const auto session = session_over(part.noisy, 6);
  for (const Change& change : std::vector<Change>{part.waves(), machined(), SetGradientScale{2}})
    ASSERT_TRUE(
        session->apply({std::to_string(session->edited().history().size()), change}).is_ok());
  StepReport last = session->step();
  while (!session->is_settled(last)) last = session->step();
  const TriangleMesh stepped = session->surface();
  const TriangleMesh solved = part.filtered({part.waves(), machined(), SetGradientScale{2}});
  EXPECT_LT(farthest(stepped, solved), 1e-4 * compute_statistics(part.noisy).diagonal());
}

void settle(Session& session) {
  StepReport last = session.step();
  while (!session.is_settled(last)) last = session.step();
}

/// A session of the part whose machined edges are kept, settled.
std::unique_ptr<Session> settled_session(const NoisyPart& part) {
  auto session = session_over(part.noisy, 6);
  EXPECT_TRUE(session->apply({"waves", part.waves()}).is_ok());
  EXPECT_TRUE(session->apply({"edges", machined()}).is_ok());
  settle(*session);
  return session;
}

TEST(KeptEdges, AFilterDoesNotHoldUpSteps) {
  const NoisyPart part;
  const auto session = session_over(part.noisy, 6);
  SetEdges slow = machined();
  slow.filter.passes = kNormalPassesMax;
  ASSERT_TRUE(session->apply({"edges", slow}).is_ok());
  session->step();
  EXPECT_FALSE(session->has_layer());
  EXPECT_FALSE(session->is_settled(session->step()));
  settle(*session);
  EXPECT_TRUE(session->has_layer());
}

TEST(KeptEdges, AnotherFilterEndsTheOneThatIsBeingMade) {
  const NoisyPart part;
  const auto session = session_over(part.noisy, 6);
  SetEdges slow = machined();
  slow.filter.passes = kNormalPassesMax;
  ASSERT_TRUE(session->apply({"waves", part.waves()}).is_ok());
  ASSERT_TRUE(session->apply({"slow", slow}).is_ok());
  session->step();
  ASSERT_TRUE(session->apply({"edges", machined()}).is_ok());
  settle(*session);
  const TriangleMesh solved = part.filtered({part.waves(), machined()});
  EXPECT_LT(farthest(session->surface(), solved), 1e-4 * compute_statistics(part.noisy).diagonal());
}

TEST(KeptEdges, AStrengthIsShownWithoutAFilterAndOtherNormalsAreNot) {
  const NoisyPart part;
  const auto session = settled_session(part);
  const auto layer = [&] {
    const auto moves = session->layer(session->displacement()).moves;
    return std::vector<Vec3f>(moves.begin(), moves.end());
  };
  const std::vector<Vec3f> whole = layer();
  session->previews().show(1, {"ann", "drag", at_strength(0.5)});
  session->step();
  const std::vector<Vec3f> half = layer();
  double sum = 0, sum_of_half = 0;
  for (size_t v = 0; v < whole.size(); ++v) {
    sum += whole[v].norm();
    sum_of_half += half[v].norm();
  }
  EXPECT_NEAR(sum_of_half / sum, 0.5, 0.01);
  SetEdges others = machined();
  others.filter.passes = 3;
  session->previews().show(1, {"ann", "drag", others});
  settle(*session);
  EXPECT_EQ(layer(), whole);
}

TEST(KeptEdges, TakeNoMoreMemoryThanPredicted) {
  const NoisyPart part;
  PrepareOptions options;
  options.depth = 6;
  const auto multigrid = *make_multigrid(*prepare(part.noisy, options), {});
  auto opened = Session::open(multigrid, {.backend = BackendKind::kCpu});
  ASSERT_TRUE(opened.is_ok());
  const auto session = std::move(opened).value();
  session->step();
  const uint64_t before = session->byte_count();
  ASSERT_TRUE(session->apply({"edges", machined()}).is_ok());
  settle(*session);
  session->layer(session->displacement());
  EXPECT_GT(session->byte_count(), before);
  EXPECT_LT(session->byte_count(), before + predict_edge_bytes(multigrid));
}

TEST(KeptEdges, BandsThatAnUndoBringsBackDoNotCount) {
  const NoisyPart part;
  const auto session = session_over(part.noisy, 5);
  ASSERT_TRUE(session->apply({"1", machined()}).is_ok());
  ASSERT_TRUE(session->apply({"2", at_strength(0)}).is_ok());
  ASSERT_TRUE(session->apply({"3", SetEqualiser{{{{0.5, 2}}}}}).is_ok());
  ASSERT_TRUE(session->apply({"4", SwitchEntry{2, false}}).is_ok());
  const Settings& settings = session->fields().settings();
  EXPECT_TRUE(settings.edges.is_on());
  EXPECT_TRUE(settings.equaliser.bands.empty());
  settle(*session);
  ASSERT_TRUE(session->apply({"5", SwitchEntry{1, false}}).is_ok());
  EXPECT_EQ(session->fields().settings().equaliser.bands.size(), 1u);
}

/// What lies in the upper half of a view that the scan fills.
Protect upper_half(const MeshStatistics& of) {
  const Vec3d middle = (of.box_min + of.box_max) / 2, half = (of.box_max - of.box_min) / 2;
  LassoRegion lasso{.polygon = {{-2, 0}, {2, 0}, {2, 2}, {-2, 2}}, .through = true};
  for (int axis = 0; axis < 3; ++axis) {
    lasso.view_projection[5 * axis] = 0.9 / half[axis];
    lasso.view_projection[4 * axis + 3] = -0.9 * middle[axis] / half[axis];
  }
  lasso.view_projection[15] = 1;
  return {.way = lasso};
}

TEST(KeptEdges, AProtectedRegionKeepsItsNoise) {
  const NoisyPart part;
  const MeshStatistics of = compute_statistics(part.noisy);
  const double height = of.box_max.y() - of.box_min.y();
  const TriangleMesh kept = part.filtered({part.waves(), machined(), upper_half(of)});
  size_t held = 0, moved = 0;
  for (size_t v = 0; v < kept.vertices.size(); ++v) {
    const double up = (part.noisy.vertices[v].y() - of.box_min.y()) / height;
    const double move = (kept.vertices[v] - part.noisy.vertices[v]).norm();
    if (up > 0.6) {
      ++held;
      EXPECT_EQ(move, 0) << v;
    }
    moved += up < 0.4 && move > 0.01 * of.mean_edge_length;
  }
  EXPECT_GT(held, 100u);
  EXPECT_GT(moved, 100u);
}

/// A dab of kept edges' strength around the part's first vertex. Lengths are parts of the diagonal.
struct EdgeDab {
  const NoisyPart& part;
  double radius = 0.25;

  double diagonal() const { return compute_statistics(part.noisy).diagonal(); }
  const Vec3d& centre() const { return part.noisy.vertices.front(); }
  Stroke of(double strength) const {
    const Brush brush{.radius = radius * diagonal(),
                      .beta = strength,
                      .fall_off = FallOff::kConstant,
                      .edges = true};
    return {brush, {centre()}};
  }
  /// Returns the mean move of the vertices from `low` to `high` radii around the centre.
  double mean_move(const TriangleMesh& moved, double low, double high) const {
    double sum = 0;
    int count = 0;
    for (size_t v = 0; v < moved.vertices.size(); ++v) {
      const Vec3d& was = part.noisy.vertices[v];
      const double radii = (was - centre()).norm() / (radius * diagonal());
      if (radii < low || radii > high) continue;
      sum += (moved.vertices[v] - was).norm();
      ++count;
    }
    EXPECT_GT(count, 50);
    return sum / count;
  }
};

TEST(KeptEdges, ABrushDenoisesWhereNothingElseDoes) {
  const NoisyPart part;
  const EdgeDab dab{part};
  const TriangleMesh painted = part.filtered({part.waves(), dab.of(1)});
  EXPECT_LT(dab.mean_move(painted, 1.5, 100), 0.02 * dab.mean_move(painted, 0, 0.7));
  const SetEdges as_painted{{.strength = 1}};
  const TriangleMesh all = part.filtered({part.waves(), as_painted});
  EXPECT_NEAR(dab.mean_move(painted, 0, 0.7) / dab.mean_move(all, 0, 0.7), 1, 0.05);
}

TEST(KeptEdges, ABrushKeepsNoiseWhereTheRestLosesIt) {
  const NoisyPart part;
  const EdgeDab dab{part};
  const TriangleMesh painted = part.filtered({part.waves(), machined(), dab.of(0)});
  EXPECT_LT(dab.mean_move(painted, 0, 0.7), 0.05 * dab.mean_move(painted, 1.5, 100));
}

TEST(KeptEdges, PaintOverTheWholeScanIsItsStrength) {
  const NoisyPart part;
  const Stroke everywhere = EdgeDab{part, 3}.of(0.5);
  const double near = 1e-6 * compute_statistics(part.noisy).diagonal();
  const TriangleMesh half = part.filtered({part.waves(), at_strength(0.5), SetGradientScale{2}});
  const TriangleMesh painted =
      part.filtered({part.waves(), machined(), SetGradientScale{2}, everywhere});
  EXPECT_LT(farthest(painted, half), near);
  EXPECT_GT(farthest(part.filtered({part.waves(), machined(), SetGradientScale{2}}), half), near);
}

TEST(KeptEdges, AStrokeThatIsUndoneLeavesNoBit) {
  const NoisyPart part;
  const EdgeDab dab{part};
  const TriangleMesh without = part.filtered({part.waves(), SetGradientScale{0.5}});
  const TriangleMesh undone =
      part.filtered({part.waves(), SetGradientScale{0.5}, dab.of(1), Undo{}});
  EXPECT_EQ(undone.vertices, without.vertices);
}

TEST(KeptEdges, StepsUnderABrushLeadToWhatASolveFinds) {
  const NoisyPart part;
  const auto session = settled_session(part);
  const std::vector<Change> changes = {EdgeDab{part, 0.1}.of(0), EdgeDab{part, 0.05}.of(0.7),
                                       SetGradientScale{2}};
  for (const Change& change : changes) {
    ASSERT_TRUE(
        session->apply({std::to_string(session->edited().history().size()), change}).is_ok());
    session->step();
  }
  settle(*session);
  const TriangleMesh solved = part.filtered({part.waves(), machined(), EdgeDab{part, 0.1}.of(0),
                                             EdgeDab{part, 0.05}.of(0.7), SetGradientScale{2}});
  EXPECT_LT(farthest(session->surface(), solved), 1e-4 * compute_statistics(part.noisy).diagonal());
}

TEST(KeptEdges, AStrokeIsShownBeforeItIsAnEdit) {
  const NoisyPart part;
  const EdgeDab dab{part};
  const auto session = settled_session(part);
  const TriangleMesh kept = session->surface();
  session->previews().show(1, {"ann", "drag", dab.of(0)});
  settle(*session);
  EXPECT_LT(dab.mean_move(session->surface(), 0, 0.7), 0.1 * dab.mean_move(kept, 0, 0.7));
  session->previews().drop(1);
  settle(*session);
  EXPECT_LT(farthest(session->surface(), kept), 1e-4 * dab.diagonal());
}

TEST(KeptEdges, NothingMovesMoreThanTheCap) {
  const NoisyPart part;
  const double cap = 0.1 * compute_statistics(part.noisy).mean_edge_length;
  const TriangleMesh kept = part.filtered({part.waves(), machined(), SetControls{{.cap = cap}}});
  EXPECT_LE(farthest(kept, part.noisy), cap);
  EXPECT_GT(farthest(kept, part.noisy), 0.99 * cap);
}

TEST(KeptEdges, ATriangleThatIsListedTwiceCountsOnce) {
  const NoisyPart part;
  TriangleMesh twice = part.noisy;
  for (const Triangle& t : part.noisy.triangles) twice.triangles.push_back({t[1], t[0], t[2]});
  SetEdges half = machined();
  half.filter.crispness = 0.5;
  const SetGradientScale sharper{2};
  const TriangleMesh once = part.filtered({part.waves(), half, sharper});
  const TriangleMesh doubled =
      exact_surface(*session_over(twice, 6), {part.waves(twice), half, sharper});
  EXPECT_LT(farthest(once, doubled), 1e-6 * compute_statistics(part.noisy).diagonal());
}

TEST(KeptEdges, BandsAreRefusedBesideThem) {
  LayerCheck check({}, false);
  ASSERT_TRUE(check.take({"1", machined()}).is_ok());
  const Status refused = check.take({"2", SetEqualiser{{{{0.5, 2}}}}});
  EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(refused.message(), HasSubstr("bands"));
  EXPECT_TRUE(check.take({"3", at_strength(0)}).is_ok());
}

TEST(KeptEdges, BandsDoNotStandBesidePaintedOnes) {
  const NoisyPart part;
  const Edit bands{"bands", SetEqualiser{{{{0.5, 2}}}}}, stroke{"stroke", EdgeDab{part}.of(1)};
  LayerCheck painted({}, false), banded({}, false);
  ASSERT_TRUE(painted.take(stroke).is_ok());
  EXPECT_EQ(painted.take(bands).code(), StatusCode::kFailedPrecondition);
  ASSERT_TRUE(banded.take(bands).is_ok());
  EXPECT_EQ(banded.take(stroke).code(), StatusCode::kFailedPrecondition);
  const auto session = session_over(part.noisy, 5);
  ASSERT_TRUE(session->apply(stroke).is_ok());
  EXPECT_EQ(session->edited().layers().take(bands).code(), StatusCode::kFailedPrecondition);
}

TEST(KeptEdges, AVolumeIsNotKeptBesideThem) {
  const NoisyPart part;
  LayerCheck check({}, false);
  ASSERT_TRUE(check.take({"1", machined()}).is_ok());
  const Status refused = check.take({"2", SetControls{{.keep_volume = true}}});
  EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(refused.message(), HasSubstr("volume"));
}

}  // namespace
}  // namespace burnish
