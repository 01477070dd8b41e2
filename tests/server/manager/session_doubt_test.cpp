// Nobody knows whether an edit is on disk: the session is replayed, and the client sends it again.

#include <atomic>
#include <future>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/journal/sqlite_journal.h"
#include "server/manager/session_manager.h"
#include "tests/server/manager/doubtful_journal.h"
#include "tests/server/manager/test_library.h"

namespace burnish {
namespace {

using Doubt = DoubtfulJournal::Doubt;
using testing::HasSubstr;

/// Notes the sessions that were lost.
class LostSessions final : public SessionListener {
 public:
  void on_session_changed(const std::string&) override {}
  void on_session_left(const std::string&, const Status&) override {}
  void on_session_lost(const std::string&, const Status& why) override { lost.push_back(why); }
  void on_session_moved(const std::string&, const Status& why) override { moved.push_back(why); }
  uint64_t client_bytes(const std::string&) const override { return 0; }

  std::vector<Status> lost, moved;
};

/// A session "one" with an edit "a".
class SessionDoubtTest : public testing::Test {
 protected:
  SessionDoubtTest() : journal_(SqliteJournal::open(library_.folder->journal()).value()) {
    EXPECT_TRUE(library_.import(sphere_file(), "ball").is_ok());
    SessionManagerOptions options;
    options.solver.threads = 1;
    manager_ =
        std::move(SessionManager::create(*library_.folder, *library_.store, journal_, options))
            .value();
    manager_->set_listener(&listener_);
    EXPECT_TRUE(manager_->open({"ball", "one", {5, 0}}, "ann", {}).is_ok());
    EXPECT_TRUE(apply("a", 0.5).is_ok());
  }
  ~SessionDoubtTest() override { manager_->set_listener(nullptr); }

  Result<ApplyOutcome> apply(const std::string& id, double beta) {
    const Edit edit{id, SetGradientScale{beta}};
    return manager_->apply("one", "ann", {&edit, 1}, {});
  }

  TestLibrary library_;
  DoubtfulJournal journal_;
  LostSessions listener_;
  std::unique_ptr<SessionManager> manager_;
};

TEST_F(SessionDoubtTest, AnEditThatIsOnDiskAfterAllIsKnownWhenItComesAgain) {
  journal_.next = Doubt::kWritten;
  EXPECT_EQ(apply("b", 2).status().code(), StatusCode::kUnavailable);
  const auto again = apply("b", 2);
  ASSERT_TRUE(again.is_ok()) << again.status().message();
  EXPECT_EQ(again->known, 1u);
  EXPECT_EQ(again->edits, 2u);
  EXPECT_EQ(manager_->state("one", {}).value().settings.beta, 2);
}

TEST_F(SessionDoubtTest, AnEditThatIsNotOnDiskIsTakenWhenItComesAgain) {
  journal_.next = Doubt::kLost;
  EXPECT_EQ(apply("b", 2).status().code(), StatusCode::kUnavailable);
  EXPECT_EQ(manager_->state("one", {}).value().settings.beta, 0.5);
  const auto again = apply("b", 2);
  ASSERT_TRUE(again.is_ok()) << again.status().message();
  EXPECT_EQ(again->applied, 1u);
  EXPECT_EQ(again->edits, 2u);
}

TEST_F(SessionDoubtTest, EverybodyInTheSessionMustComeBackOnce) {
  journal_.next = Doubt::kWritten;
  EXPECT_FALSE(apply("b", 2).is_ok());
  ASSERT_EQ(listener_.lost.size(), 1u);
  EXPECT_EQ(listener_.lost[0].code(), StatusCode::kUnavailable);
  EXPECT_THAT(listener_.lost[0].message(), HasSubstr("sync"));
  EXPECT_TRUE(apply("c", 3).is_ok());
  EXPECT_EQ(listener_.lost.size(), 1u);
}

TEST_F(SessionDoubtTest, EditsBehindOneInDoubtAreInDoubtToo) {
  std::promise<void> disk;
  journal_.append(manager_->list()[0].id, 2, {},
                  [&](const WriteOutcome&) { disk.get_future().wait(); });
  std::promise<Status> first, second;
  const Edit b{"b", SetGradientScale{2}}, c{"c", SetGradientScale{3}};
  journal_.next = Doubt::kLost;
  ASSERT_TRUE(manager_
                  ->submit("one", "ann", {&b, 1}, {},
                           [&](const Status& status) { first.set_value(status); })
                  .is_ok());
  ASSERT_TRUE(manager_
                  ->submit("one", "ann", {&c, 1}, {},
                           [&](const Status& status) { second.set_value(status); })
                  .is_ok());
  disk.set_value();
  EXPECT_EQ(first.get_future().get().code(), StatusCode::kUnavailable);
  EXPECT_EQ(second.get_future().get().code(), StatusCode::kUnavailable);
  EXPECT_EQ(listener_.lost.size(), 1u);
}

TEST_F(SessionDoubtTest, ACallDoesNotWaitForTheDiskOfASessionThatWasLetGo) {
  std::promise<void> disk;
  journal_.append(manager_->list()[0].id, 2, {},
                  [&](const WriteOutcome&) { disk.get_future().wait(); });
  auto waiting = std::async(std::launch::async, [this] { return apply("b", 2).status(); });
  while (manager_->list()[0].edits < 2) std::this_thread::yield();
  manager_->let_go(unavailable("the lease is over"));
  EXPECT_EQ(waiting.get().code(), StatusCode::kUnavailable);
  EXPECT_EQ(listener_.moved.size(), 1u);
  disk.set_value();
  const auto again = apply("b", 2);
  ASSERT_TRUE(again.is_ok()) << again.status().message();
  EXPECT_EQ(again->known, 1u);
}

TEST_F(SessionDoubtTest, NoSessionIsUsedWhileAnotherServerMayHaveIt) {
  std::atomic<bool> is_lost{false};
  manager_->set_hold_check(
      [&] { return is_lost ? unavailable("the lease is over") : Status::ok(); });
  EXPECT_TRUE(apply("b", 2).is_ok());
  is_lost = true;
  for (int i = 0; i < 2; ++i) {
    EXPECT_THAT(apply("c", 3).status().message(), HasSubstr("the lease is over"));
    EXPECT_EQ(manager_->state("one", {}).status().code(), StatusCode::kUnavailable);
    EXPECT_EQ(manager_->open({"ball", "two", {5, 0}}, "ann", {}).status().code(),
              StatusCode::kUnavailable);
    EXPECT_EQ(listener_.moved.size(), 1u) << "each is told once";
  }
  is_lost = false;
  EXPECT_TRUE(apply("c", 3).is_ok());
  is_lost = true;
  EXPECT_FALSE(manager_->check_hold().is_ok());
  EXPECT_EQ(listener_.moved.size(), 2u);
}

}  // namespace
}  // namespace burnish
