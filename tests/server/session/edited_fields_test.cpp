#include "server/session/edited_fields.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "common/grid/morton.h"
#include "server/prepare/prepare.h"

namespace burnish {
namespace {

class EditedFieldsTest : public testing::Test {
 protected:
  static std::shared_ptr<const PreparedMesh> prepared_sphere(int depth = 4) {
    PrepareOptions options;
    options.depth = depth;
    return *prepare(make_icosphere(2, 1), options);
  }

  static Stroke stroke(int i) {
    return {{0.4, 0.6, 0.01 * i, FallOff::kSmooth},
            {Vec3d(std::cos(0.3 * i), std::sin(0.3 * i), 0)}};
  }

  /// A stroke with so many dabs that it is painted in several pieces.
  static Stroke long_stroke(int i) {
    Stroke stroke{{0.8, 0.3, 0.1 * i, FallOff::kSmooth}, {}};
    for (int turn = 0; turn < 400; ++turn)
      stroke.path.emplace_back(1 - 2 * (turn % 2), 0.1 * i, 0.4);
    return stroke;
  }

  AuthoredEdit authored(decltype(Edit::change) change) {
    return {"ann", 0, {std::to_string(++last_id_), std::move(change)}};
  }
  Status apply(EditedFields& edited, decltype(Edit::change) change) {
    const AuthoredEdit edit = authored(std::move(change));
    return edited.apply({&edit, 1}).status();
  }

  static std::vector<float> beta(const EditedFields& edited) {
    const auto view = edited.fields().view().beta;
    return {view.begin(), view.end()};
  }

  /// Returns how many strokes the call has painted.
  static uint64_t painted_by(EditedFields& edited, const std::function<void()>& call) {
    const uint64_t before = edited.painted_strokes();
    call();
    return edited.painted_strokes() - before;
  }

  std::shared_ptr<const PreparedMesh> prepared_ = prepared_sphere();
  int last_id_ = 0;
};

TEST_F(EditedFieldsTest, AnUndoneStrokeIsAsIfItHadNeverBeen) {
  EditedFields edited(*prepared_), without(*prepared_);
  for (int i = 0; i < 40; ++i) {
    ASSERT_TRUE(apply(edited, stroke(i)).is_ok());
    if (i == 20) continue;
    ASSERT_TRUE(apply(without, stroke(i)).is_ok());
  }
  ASSERT_TRUE(apply(edited, SwitchEntry{21, false}).is_ok());
  EXPECT_EQ(beta(edited), beta(without));
}

TEST_F(EditedFieldsTest, BatchesDoNotMatter) {
  EditedFields one_by_one(*prepared_), at_once(*prepared_);
  std::vector<AuthoredEdit> edits;
  for (int i = 0; i < 50; ++i) edits.push_back(authored(stroke(i)));
  for (const AuthoredEdit& edit : edits) ASSERT_TRUE(one_by_one.apply({&edit, 1}).is_ok());
  ASSERT_TRUE(at_once.apply(edits).is_ok());
  EXPECT_EQ(beta(one_by_one), beta(at_once));
}

TEST_F(EditedFieldsTest, AnUndoNextToTheEndReplaysAlmostNothing) {
  EditedFields edited(*prepared_);
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(apply(edited, stroke(i)).is_ok());
  EXPECT_EQ(painted_by(edited, [&] { ASSERT_TRUE(apply(edited, Undo{}).is_ok()); }), 0u);
  EXPECT_EQ(painted_by(edited, [&] { ASSERT_TRUE(apply(edited, Redo{}).is_ok()); }), 0u);
  const uint64_t all = painted_by(edited, [&] {
    for (int i = 0; i < 200; ++i) ASSERT_TRUE(apply(edited, Undo{}).is_ok());
  });
  EXPECT_LT(all, 1000u);  // a few each
  EXPECT_EQ(beta(edited), beta(EditedFields(*prepared_)));
}

TEST_F(EditedFieldsTest, KeptCheckpointsBoundTheReplayOfANewStart) {
  EditedFields edited(*prepared_);
  std::vector<AuthoredEdit> edits;
  std::vector<PaintCheckpoint> kept;
  for (int i = 0; i < 150; ++i) {
    edits.push_back(authored(stroke(i)));
    ASSERT_TRUE(edited.apply({&edits.back(), 1}).is_ok());
    for (PaintCheckpoint& checkpoint : edited.take_kept()) kept.push_back(std::move(checkpoint));
  }
  EditedFields again(*prepared_);
  for (const PaintCheckpoint& checkpoint : kept) again.offer(checkpoint);
  ASSERT_TRUE(again.apply(edits).is_ok());
  EXPECT_LT(again.painted_strokes(), EditedFields::kStrokesPerKeptCheckpoint);
  EXPECT_EQ(beta(again), beta(edited));
}

TEST_F(EditedFieldsTest, ACheckpointOfOtherStrokesIsNotUsed) {
  EditedFields edited(*prepared_), other(*prepared_), plain(*prepared_);
  for (int i = 0; i < 32; ++i) ASSERT_TRUE(apply(other, stroke(i + 1)).is_ok());
  for (PaintCheckpoint& checkpoint : other.take_kept()) edited.offer(std::move(checkpoint));
  std::vector<AuthoredEdit> edits;
  for (int i = 0; i < 33; ++i) edits.push_back(authored(stroke(i)));
  ASSERT_TRUE(edited.apply(edits).is_ok());
  ASSERT_TRUE(plain.apply(edits).is_ok());
  EXPECT_EQ(edited.painted_strokes(), 33u);
  EXPECT_EQ(beta(edited), beta(plain));
}

TEST_F(EditedFieldsTest, TheSolverHearsOnlyOfWhatChanged) {
  EditedFields edited(*prepared_);
  (void)edited.take_changes();
  const auto changes = [&](decltype(Edit::change) change) {
    EXPECT_TRUE(apply(edited, std::move(change)).is_ok());
    const EditEffects changed = edited.take_changes();
    return std::string(changed.metric ? "matrix " : "") + (changed.beta ? "rhs" : "");
  };
  EXPECT_EQ(changes(SetGradientScale{0.5}), "rhs");
  EXPECT_EQ(changes(SetGradientScale{0.5}), "");
  EXPECT_EQ(changes(stroke(1)), "rhs");
  EXPECT_EQ(changes(SetTransferCurve{TransferCurve(5)}), "matrix ");
  EXPECT_EQ(changes(Undo{}), "matrix ");
  EXPECT_EQ(changes(SetCheckpoint{"x"}), "");
  EXPECT_EQ(changes(Undo{}), "rhs");
  EXPECT_EQ(changes(RestoreCheckpoint{"x"}), "rhs");
}

TEST_F(EditedFieldsTest, AFailedBatchChangesNothing) {
  EditedFields edited(*prepared_);
  ASSERT_TRUE(apply(edited, stroke(1)).is_ok());
  const std::vector<float> before = beta(edited);
  const std::vector<AuthoredEdit> batch = {authored(stroke(2)), authored(Undo{}), authored(Undo{}),
                                           authored(SetGradientScale{2}), authored(Redo{})};
  const auto outcome = edited.apply(batch);
  EXPECT_EQ(outcome.status().code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(outcome.status().message(), testing::HasSubstr("edit " + batch.back().edit.id));
  EXPECT_EQ(beta(edited), before);
  EXPECT_EQ(edited.history().size(), 1u);
}

TEST_F(EditedFieldsTest, AReplayThatPausesAnywhereGivesTheSameFields) {
  const auto prepared = prepared_sphere(6);
  EditedFields at_once(*prepared), in_pieces(*prepared);
  const std::vector<AuthoredEdit> edits = {authored(long_stroke(1)), authored(long_stroke(2)),
                                           authored(Undo{}), authored(long_stroke(3)),
                                           authored(SetGradientScale{0.5})};
  ASSERT_TRUE(at_once.apply(edits).is_ok());
  int pauses = 0;
  const auto one_piece = [&](int pieces) {
    return [pieces](std::string_view, double) mutable { return pieces-- > 0; };
  };
  for (size_t i = 0; i < edits.size(); ++i) {
    ASSERT_TRUE(in_pieces.record({&edits[i], 1}).is_ok());
    // New edits come before the last ones are painted; one undoes a stroke that is half painted.
    pauses += in_pieces.catch_up(one_piece(3)).is_ok() ? 0 : 1;
  }
  while (!in_pieces.catch_up(one_piece(1)).is_ok()) ++pauses;
  EXPECT_GT(pauses, 5);
  EXPECT_FALSE(in_pieces.is_behind());
  EXPECT_EQ(beta(in_pieces), beta(at_once));
}

Stroke connected(Stroke stroke) {
  stroke.brush.connected = true;
  return stroke;
}

TEST_F(EditedFieldsTest, AConnectedStrokeThatPausesAnywhereGivesTheSameFields) {
  prepared_ = prepared_sphere(6);
  Stroke over_it{{0.6, 0.3, 3, FallOff::kSmooth}, {}};
  for (int i = 0; i <= 60; ++i) over_it.path.emplace_back(std::cos(0.1 * i), 0, std::sin(0.1 * i));
  EditedFields at_once(*prepared_), in_pieces(*prepared_);
  const std::vector<AuthoredEdit> edits = {authored(connected(over_it)), authored(stroke(1)),
                                           authored(connected(stroke(2)))};
  ASSERT_TRUE(at_once.apply(edits).is_ok());
  ASSERT_TRUE(in_pieces.record(edits).is_ok());
  int pauses = 0;
  for (int calls = 0; in_pieces.is_behind(); ++pauses)
    (void)in_pieces.catch_up([&](std::string_view, double) { return ++calls % 2 != 0; });
  EXPECT_GT(pauses, 3);
  EXPECT_EQ(beta(in_pieces), beta(at_once));
  ASSERT_TRUE(apply(at_once, Undo{}).is_ok());
  EXPECT_NE(beta(in_pieces), beta(at_once));
}

TEST_F(EditedFieldsTest, ACancelledReplayChangesNothing) {
  EditedFields edited(*prepared_);
  ASSERT_TRUE(apply(edited, stroke(1)).is_ok());
  const std::vector<float> before = beta(edited);
  const std::vector<AuthoredEdit> batch = {authored(stroke(2)), authored(stroke(3))};
  const auto outcome =
      edited.apply(batch, [calls = 0](std::string_view, double) mutable { return ++calls < 2; });
  EXPECT_EQ(outcome.status().code(), StatusCode::kCancelled);
  EXPECT_EQ(beta(edited), before);
  EXPECT_TRUE(edited.apply(batch).is_ok());
}

/// Returns an edit of all cells, or of each `step`-th.
static SetCellFields cells_of(const PreparedMesh& prepared, CellTarget target, double value,
                              size_t step = 1) {
  SetCellFields change{{}, target};
  for (size_t c = 0; c < prepared.cells.size(); c += step)
    change.cells.push_back({morton_point(prepared.cells[c]), 0, 0, value});
  return change;
}

static std::vector<float> strengths(const EditedFields& edited) {
  const PaintLayer* const paint = edited.fields().edge_paint();
  return paint ? paint->value : std::vector<float>();
}

TEST_F(EditedFieldsTest, CellsOfKeptEdgesAreAStrokeAmongStrokes) {
  Stroke over = stroke(1);
  over.brush.edges = true;
  EditedFields edited(*prepared_), swapped(*prepared_);
  const SetCellFields cells = cells_of(*prepared_, CellTarget::kEdges, 0.25);
  ASSERT_TRUE(apply(edited, cells).is_ok());
  EXPECT_EQ(strengths(edited), std::vector<float>(prepared_->cells.size(), 0.25f));
  ASSERT_TRUE(apply(edited, over).is_ok());
  EXPECT_NE(strengths(edited), std::vector<float>(prepared_->cells.size(), 0.25f));
  EXPECT_EQ(beta(edited), beta(swapped));
  ASSERT_TRUE(apply(swapped, over).is_ok());
  ASSERT_TRUE(apply(swapped, cells).is_ok());
  EXPECT_EQ(strengths(swapped), std::vector<float>(prepared_->cells.size(), 0.25f));
  ASSERT_TRUE(apply(edited, SwitchEntry{1, false}).is_ok());
  ASSERT_TRUE(apply(swapped, Undo{}).is_ok());
  EXPECT_EQ(strengths(edited), strengths(swapped));
}

TEST_F(EditedFieldsTest, CellsOfAProtectionProtectAndReleaseInTheirOrder) {
  EditedFields edited(*prepared_);
  const size_t all = prepared_->cells.size();
  ASSERT_TRUE(apply(edited, cells_of(*prepared_, CellTarget::kProtection, 1)).is_ok());
  EXPECT_EQ(edited.protection().cells().size(), all);
  ASSERT_TRUE(apply(edited, cells_of(*prepared_, CellTarget::kProtection, 0, 2)).is_ok());
  EXPECT_EQ(edited.protection().cells().size(), all / 2);
  ASSERT_TRUE(apply(edited, Protect{InvertedRegion{}}).is_ok());
  EXPECT_EQ(edited.protection().cells().size(), all - all / 2);
  EXPECT_TRUE(edited.protection().has(0));
  ASSERT_TRUE(apply(edited, cells_of(*prepared_, CellTarget::kEdges, 1)).is_ok());
  const PaintLayer& paint = *edited.fields().edge_paint();
  EXPECT_EQ(paint.weight[0], 0);  // it is protected
  EXPECT_EQ(paint.weight[1], 1);
}

TEST(PaintedBytes, DamageIsSeen) {
  const PaintedCells painted = {{1, 5, 9}, {0.5f, 1, 2}, {1, 0.5f, 0.25f}};
  const std::string bytes = painted_to_bytes(painted);
  EXPECT_EQ(painted_from_bytes(bytes, 10).value(), painted);
  for (size_t i = 0; i < bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 1);
    EXPECT_EQ(painted_from_bytes(damaged, 10).status().code(), StatusCode::kDataLoss);
  }
  EXPECT_FALSE(painted_from_bytes(bytes.substr(0, bytes.size() - 1), 10).is_ok());
}

TEST_F(EditedFieldsTest, RestoringSkipsWhatIsDamagedAndWhatIsRefusedByNow) {
  std::vector<AuthoredEdit> edits = {authored(stroke(1)), authored(stroke(2)),
                                     authored(SetCellFields{{{Vec3i(-9, -9, -9), 1, 1, 1}}}),
                                     authored(SetGradientScale{0.5})};
  edits[1].edit.change = Damaged{"a hole"};
  EditedFields restored(*prepared_);
  EXPECT_EQ(restored.restore(edits), 2u);
  ASSERT_TRUE(restored.catch_up().is_ok());
  EXPECT_EQ(restored.history().size(), 4u);
  EXPECT_TRUE(restored.history().entries()[1].is_damaged());
  EXPECT_TRUE(restored.history().entries()[2].is_damaged());

  EditedFields expected(*prepared_);
  ASSERT_TRUE(apply(expected, stroke(1)).is_ok());
  ASSERT_TRUE(apply(expected, SetGradientScale{0.5}).is_ok());
  EXPECT_EQ(beta(restored), beta(expected));
}

TEST_F(EditedFieldsTest, ADamagedEditCannotBeApplied) {
  EditedFields edited(*prepared_);
  EXPECT_EQ(apply(edited, Damaged{"a hole"}).code(), StatusCode::kDataLoss);
}

/// All cells of the upper half, z > 0.
Protect upper_half() {
  LassoRegion lasso;
  lasso.view_projection = {1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1};  // y is the height
  lasso.polygon = {{-2, 0}, {2, 0}, {2, 2}, {-2, 2}};
  lasso.through = true;
  return {lasso};
}

/// Around the equator.
Stroke over_the_border(double beta) {
  return {{0.5, 1, beta, FallOff::kConstant}, {Vec3d(1, 0, 0)}};
}
const Stroke kAtTheTop{{0.4, 1, 3, FallOff::kSmooth}, {Vec3d(0, 0, 1)}};

size_t cells_at(const std::vector<float>& beta, float value) {
  return static_cast<size_t>(std::count(beta.begin(), beta.end(), value));
}

TEST_F(EditedFieldsTest, AStrokeWhollyInsideTheProtectedRegionIsRefused) {
  EditedFields edited(*prepared_);
  EXPECT_TRUE(edited.check_new({"a", kAtTheTop}).is_ok());
  ASSERT_TRUE(apply(edited, upper_half()).is_ok());
  const Status refused = edited.check_new({"a", kAtTheTop});
  EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(refused.message(), testing::HasSubstr("protected"));
  EXPECT_EQ(edited.check_new({"a", connected(kAtTheTop)}).code(), StatusCode::kFailedPrecondition);
  EXPECT_TRUE(edited.check_new({"a", over_the_border(3)}).is_ok());
  EXPECT_TRUE(edited.check_new({"a", connected(over_the_border(3))}).is_ok());
  ASSERT_TRUE(apply(edited, Protect{NoRegion{}}).is_ok());
  EXPECT_TRUE(edited.check_new({"a", kAtTheTop}).is_ok());
}

TEST_F(EditedFieldsTest, PaintOverTheBorderOfTheRegionStaysOutsideAfterItsRelease) {
  EditedFields edited(*prepared_), free(*prepared_);
  ASSERT_TRUE(apply(edited, upper_half()).is_ok());
  ASSERT_TRUE(apply(edited, connected(over_the_border(3))).is_ok());
  ASSERT_TRUE(apply(edited, Protect{NoRegion{}}).is_ok());
  ASSERT_TRUE(apply(free, over_the_border(3)).is_ok());
  const size_t outside = cells_at(beta(edited), 3), all = cells_at(beta(free), 3);
  EXPECT_GT(outside, 0u);
  EXPECT_NEAR(double(outside), 0.5 * double(all), 0.25 * double(all));
}

TEST_F(EditedFieldsTest, ARegionCountsForLaterStrokesAloneAndUntilItIsUndone) {
  EditedFields edited(*prepared_), first(*prepared_), both(*prepared_);
  ASSERT_TRUE(apply(first, over_the_border(3)).is_ok());
  ASSERT_TRUE(apply(both, over_the_border(3)).is_ok());
  ASSERT_TRUE(apply(both, over_the_border(2)).is_ok());
  ASSERT_TRUE(apply(edited, over_the_border(3)).is_ok());
  ASSERT_TRUE(apply(edited, upper_half()).is_ok());
  ASSERT_TRUE(apply(edited, Protect{NoRegion{}}).is_ok());
  EXPECT_EQ(beta(edited), beta(first));
  ASSERT_TRUE(apply(edited, Undo{}).is_ok());
  ASSERT_TRUE(apply(edited, over_the_border(2)).is_ok());
  const auto protected_upper = beta(edited);
  ASSERT_TRUE(apply(edited, SwitchEntry{2, false}).is_ok());
  EXPECT_EQ(beta(edited), beta(both));
  ASSERT_TRUE(apply(edited, SwitchEntry{2, true}).is_ok());
  EXPECT_EQ(beta(edited), protected_upper);
}

TEST_F(EditedFieldsTest, ALongStrokePaintedInPiecesLeavesTheRegionOutInEachOfThem) {
  prepared_ = prepared_sphere(6);
  EditedFields at_once(*prepared_), in_pieces(*prepared_);
  ASSERT_TRUE(apply(at_once, upper_half()).is_ok());
  ASSERT_TRUE(apply(in_pieces, upper_half()).is_ok());
  const AuthoredEdit edit = authored(long_stroke(1));
  ASSERT_TRUE(at_once.apply({&edit, 1}).is_ok());
  ASSERT_TRUE(in_pieces.record({&edit, 1}).is_ok());
  int calls = 0;
  const auto one_piece = [&](std::string_view, double) { return ++calls % 2 != 0; };
  while (!in_pieces.catch_up(one_piece).is_ok()) {
  }
  EXPECT_GT(calls, 2);
  EXPECT_EQ(beta(in_pieces), beta(at_once));
}

}  // namespace
}  // namespace burnish
