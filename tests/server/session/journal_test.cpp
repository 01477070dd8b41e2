#include "server/session/journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/wire/edit_bytes.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::HasSubstr;

SessionRecord record(const std::string& name) {
  return {"id-" + name, name, std::string(64, 'a'), {7, 0.5}, 1234};
}

std::vector<Edit> some_edits() {
  return {{"1", SetGradientScale{0.5}},
          {"2", SetTransferCurve{TransferCurve(20)}},
          {"3", Stroke{{1, 1, 2, FallOff::kSmooth}, {Vec3d(1, 2, 3)}}}};
}

TEST(Journal, SessionsAndEditsComeBackFromANewProgram) {
  const TemporaryFolder folder;
  {
    const auto journal = std::move(Journal::open(folder / "j.sqlite")).value();
    ASSERT_TRUE(journal->create_session(record("b")).is_ok());
    ASSERT_TRUE(journal->create_session(record("a")).is_ok());
    ASSERT_TRUE(journal->append("id-a", some_edits()).is_ok());
  }
  const auto journal = std::move(Journal::open(folder / "j.sqlite")).value();
  const auto sessions = journal->sessions().value();
  ASSERT_EQ(sessions.size(), 2u);
  EXPECT_EQ(sessions[0].name, "a");
  EXPECT_EQ(sessions[0].key, (PreparedKey{7, 0.5}));
  EXPECT_EQ(sessions[0].created_unix_seconds, 1234);
  const auto edits = journal->edits("id-a").value();
  ASSERT_EQ(edits.size(), 3u);
  for (size_t i = 0; i < edits.size(); ++i)
    EXPECT_EQ(edit_to_bytes(edits[i]), edit_to_bytes(some_edits()[i]));
  EXPECT_EQ(journal->edit_count("id-a").value(), 3u);
  EXPECT_EQ(journal->edit_count("id-b").value(), 0u);
}

TEST(Journal, ABatchWithAKnownIdIsKeptOutWhole) {
  const TemporaryFolder folder;
  const auto journal = std::move(Journal::open(folder / "j.sqlite")).value();
  ASSERT_TRUE(journal->create_session(record("a")).is_ok());
  const std::vector<Edit> first = {{"x", SetGradientScale{0.5}}};
  const std::vector<Edit> second = {{"y", SetGradientScale{0.6}}, {"x", SetGradientScale{0.7}}};
  ASSERT_TRUE(journal->append("id-a", first).is_ok());
  EXPECT_EQ(journal->append("id-a", second).code(), StatusCode::kAlreadyExists);
  EXPECT_EQ(journal->edit_count("id-a").value(), 1u);
}

TEST(Journal, RemovingASessionForgetsItsEdits) {
  const TemporaryFolder folder;
  const auto journal = std::move(Journal::open(folder / "j.sqlite")).value();
  ASSERT_TRUE(journal->create_session(record("a")).is_ok());
  ASSERT_TRUE(journal->append("id-a", some_edits()).is_ok());
  ASSERT_TRUE(journal->remove_session("id-a").is_ok());
  EXPECT_TRUE(journal->sessions().value().empty());
  EXPECT_TRUE(journal->edits("id-a").value().empty());
}

TEST(Journal, EditsOfNoSessionAreRefused) {
  const TemporaryFolder folder;
  const auto journal = std::move(Journal::open(folder / "j.sqlite")).value();
  EXPECT_FALSE(journal->append("nobody", some_edits()).is_ok());
}

TEST(Journal, AFileThatIsNoJournalIsDataLoss) {
  const TemporaryFolder folder;
  folder.write("j.sqlite", std::string(5000, 'x'));
  const auto journal = Journal::open(folder / "j.sqlite");
  EXPECT_EQ(journal.status().code(), StatusCode::kDataLoss);
  EXPECT_THAT(journal.status().message(), HasSubstr("j.sqlite"));
}

}  // namespace
}  // namespace burnish
