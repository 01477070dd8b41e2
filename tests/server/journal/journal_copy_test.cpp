#include "server/journal/journal_copy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/wire/edit_bytes.h"
#include "tests/server/journal/journal_place.h"

namespace burnish {
namespace {

using testing::HasSubstr;

/// Returns an edit of each kind that a client can send.
std::vector<AuthoredEdit> one_of_each_kind() {
  const std::vector<decltype(Edit::change)> changes = {
      SetGradientScale{0.25},
      SetTransferCurve{TransferCurve(20)},
      Stroke{{1, 1, 2, FallOff::kSmooth}, {Vec3d(1, 2, 3), Vec3d(4, 5, 6)}},
      SetCellFields{{{Vec3i(1, 2, 3), 1, 2, 3}}},
      SetControls{{.pin_rims = true, .cap = 0.5}},
      Protect{InvertedRegion{}},
      SetEqualiser{{{{0.5, 2}}}},
      SetPalette{{{{"grooves", 0x112233, TransferCurve(7)}}}},
      SetColour{{20, 0.5}},
      SetTexture{{2, 0.25}},
      SetEdges{{0.5, NormalFilterKind::kEdges, 40, 7, 0.25}},
      Undo{},
      Redo{},
      SwitchEntry{1, false},
      SetCheckpoint{"then"},
      RestoreCheckpoint{"then"}};
  std::vector<AuthoredEdit> edits;
  for (const auto& change : changes) {
    const auto number = static_cast<int64_t>(edits.size());
    edits.push_back({number % 2 ? "ann" : "", number, {"e" + std::to_string(number), change}});
  }
  return edits;
}

/// A journal of one kind with all kinds of edits, and an empty one of the other kind.
class JournalCopyTest : public testing::TestWithParam<JournalKind> {
 protected:
  JournalCopyTest() {
    SessionRecord record{"id-a", "a", std::string(64, 'a'), {7, 0.5}, 1234};
    record.controls.pin_rims = true;
    record.maker = "maria";
    EXPECT_TRUE(source_->create_session(record, SessionRoles::of_new_session("ann")).is_ok());
    EXPECT_TRUE(source_->append("id-a", 1, one_of_each_kind()).is_on_disk());
    EXPECT_TRUE(source_->create_session({"id-b", "b", "s", {5, 0}, 1}, {}).is_ok());
  }

  void reopen_target() {
    target_.reset();
    target_ = target_place_.open();
  }

  static JournalKind other(JournalKind kind) {
    return kind == JournalKind::kSqlite ? JournalKind::kPostgres : JournalKind::kSqlite;
  }

  JournalPlace source_place_{GetParam()}, target_place_{other(GetParam())};
  std::unique_ptr<Journal> source_ = source_place_.open(), target_ = target_place_.open();
};

INSTANTIATE_TEST_SUITE_P(From, JournalCopyTest, testing::ValuesIn(kJournalKinds), name_of_kind);

TEST_P(JournalCopyTest, EveryKindOfEditArrivesAsItWas) {
  static_assert(std::variant_size_v<decltype(Edit::change)> == 17, "add the new kind");
  const auto copied = copy_journal(*source_, *target_);
  ASSERT_TRUE(copied.is_ok()) << copied.status().message();
  EXPECT_EQ(copied->sessions, 2u);
  EXPECT_EQ(copied->edits, one_of_each_kind().size());
  reopen_target();
  const auto before = source_->edits("id-a").value(), after = target_->edits("id-a").value();
  ASSERT_EQ(after.size(), one_of_each_kind().size());
  for (size_t i = 0; i < after.size(); ++i) {
    EXPECT_EQ(after[i].author, before[i].author);
    EXPECT_EQ(after[i].unix_ms, before[i].unix_ms);
    EXPECT_EQ(edit_to_bytes(after[i].edit), edit_to_bytes(before[i].edit));
  }
}

TEST_P(JournalCopyTest, SessionsAndRolesArriveAsTheyWere) {
  ASSERT_TRUE(source_->set_role("id-a", "bob", SessionRole::kViewer).is_ok());
  ASSERT_TRUE(copy_journal(*source_, *target_).is_ok());
  reopen_target();
  const auto sessions = target_->sessions().value();
  ASSERT_EQ(sessions.size(), 2u);
  EXPECT_FALSE(sessions[0].is_damaged);
  EXPECT_TRUE(sessions[0].controls.pin_rims);
  EXPECT_EQ(sessions[0].maker, "maria");
  EXPECT_EQ(sessions[1].maker, std::nullopt);
  EXPECT_EQ(sessions[0].key, (PreparedKey{7, 0.5}));
  EXPECT_EQ(sessions[0].created_unix_seconds, 1234);
  EXPECT_EQ(target_->roles("id-a")->of("ann"), SessionRole::kOwner);
  EXPECT_EQ(target_->roles("id-a")->of("bob"), SessionRole::kViewer);
  EXPECT_EQ(target_->edit_count("id-b").value(), 0u);
}

TEST_P(JournalCopyTest, ASessionOfTheCopyTakesEdits) {
  ASSERT_TRUE(copy_journal(*source_, *target_).is_ok());
  reopen_target();
  ASSERT_TRUE(target_->hold("id-a").is_ok());
  const uint64_t next = one_of_each_kind().size() + 1;
  EXPECT_TRUE(target_->append("id-a", next, {{"ann", 0, {"x", Undo{}}}}).is_on_disk());
}

TEST_P(JournalCopyTest, ATargetWithSessionsIsLeftAlone) {
  ASSERT_TRUE(target_->create_session({"id-c", "carving", "s", {5, 0}, 1}, {}).is_ok());
  const Status refused = copy_journal(*source_, *target_).status();
  EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(refused.message(), HasSubstr("carving"));
  EXPECT_EQ(target_->sessions().value().size(), 1u);
}

TEST_P(JournalCopyTest, ADamagedEditStaysDamagedAndADamagedSessionStopsTheCopy) {
  source_.reset();
  ASSERT_TRUE(source_place_.change("UPDATE edits SET unix_ms = 77 WHERE number = 3").is_ok());
  source_ = source_place_.open();
  ASSERT_TRUE(copy_journal(*source_, *target_).is_ok());
  EXPECT_EQ(kind_of(target_->edits("id-a").value()[2].edit), EditKind::kDamaged);
  ASSERT_TRUE(target_->remove_session("id-a").is_ok());
  ASSERT_TRUE(target_->remove_session("id-b").is_ok());
  source_.reset();
  ASSERT_TRUE(source_place_.change("UPDATE sessions SET depth = 8").is_ok());
  source_ = source_place_.open();
  EXPECT_EQ(copy_journal(*source_, *target_).status().code(), StatusCode::kDataLoss);
  EXPECT_TRUE(target_->sessions().value().empty());
}

}  // namespace
}  // namespace burnish
