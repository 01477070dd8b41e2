#include "server/journal/group_commit.h"

#include <future>
#include <latch>

#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

/// A table of blobs on a disk with room for about 100 kB.
class GroupCommitTest : public testing::Test {
 protected:
  GroupCommitTest() {
    Database database = std::move(Database::open(folder_ / "d.sqlite")).value();
    EXPECT_TRUE(database.execute("CREATE TABLE blobs (bytes BLOB)").is_ok());
    EXPECT_TRUE(database.execute("PRAGMA max_page_count = 30").is_ok());
    commit_ = std::make_unique<GroupCommit>(std::move(database));
    // All later posts share a commit.
    commit_->post([](Database&) { return Status::ok(); },
                  [this](const WriteOutcome&) { go_on_.wait(); });
  }

  static GroupCommit::Work insert(int64_t bytes) {
    return [bytes](Database& database) {
      auto statement = database.prepare("INSERT INTO blobs VALUES (zeroblob(?))").value();
      return statement.bind(bytes).run();
    };
  }

  static GroupCommit::Done into(std::promise<Status>& outcome) {
    return [&](const WriteOutcome& written) { outcome.set_value(written.status()); };
  }

  const TemporaryFolder folder_;
  std::latch go_on_{1};
  std::unique_ptr<GroupCommit> commit_;
  std::promise<Status> small_, large_, other_;
};

TEST_F(GroupCommitTest, WorkInTheBackgroundThatFillsTheDiskLeavesTheOthersAlone) {
  commit_->post(insert(1), into(small_));
  commit_->post_background(insert(1'000'000), into(large_));
  commit_->post(insert(1), into(other_));
  go_on_.count_down();
  EXPECT_TRUE(small_.get_future().get().is_ok());
  EXPECT_TRUE(other_.get_future().get().is_ok());
  EXPECT_EQ(large_.get_future().get().code(), StatusCode::kResourceExhausted);
}

TEST_F(GroupCommitTest, OneItemThatFillsTheDiskLeavesTheOthersOfItsCommitAlone) {
  commit_->post(insert(1), into(small_));
  commit_->post(insert(1'000'000), into(large_));
  commit_->post(insert(1), into(other_));
  go_on_.count_down();
  EXPECT_TRUE(small_.get_future().get().is_ok());
  EXPECT_EQ(large_.get_future().get().code(), StatusCode::kResourceExhausted);
  EXPECT_TRUE(other_.get_future().get().is_ok());
}

TEST_F(GroupCommitTest, AReadSeesWhatWasPostedInTheBackground) {
  commit_->post_background(insert(1), into(small_));
  go_on_.count_down();
  EXPECT_TRUE(commit_
                  ->read([](Database& database) {
                    auto query = database.prepare("SELECT COUNT(*) FROM blobs").value();
                    EXPECT_TRUE(query.run().is_ok());
                    EXPECT_EQ(query.integer(0), 1);
                    return Status::ok();
                  })
                  .is_ok());
}

TEST_F(GroupCommitTest, EveryCallbackHasRunWhenTheDestructorReturns) {
  int heard = 0;
  for (int i = 0; i < 10; ++i) commit_->post(insert(1), [&](const WriteOutcome&) { ++heard; });
  commit_->post_background(insert(1), [&](const WriteOutcome&) { ++heard; });
  go_on_.count_down();
  commit_.reset();
  EXPECT_EQ(heard, 11);
}

}  // namespace
}  // namespace burnish
