// A commit whose outcome nobody knows, in a real server: the sync of the journal is done, and
// fails. Clients come back and send again, and the edit is there once.

#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/connection/session_link.h"
#include "tests/system/fetched_pages.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;

constexpr int kDoubtDepth = 4;

/// A client that notes how often it was welcomed, and the answers to its edits.
class DoubtingClient {
 public:
  DoubtingClient(const std::string& address, const std::string& user, milliseconds retry_after)
      : connection_(Connection::open(address, kPatience).value()),
        pages_(fetch_all_pages(connection_, "ball")) {
    connection_.set_user(user);
    LiveOptions options = pages_.live_options("work", kDoubtDepth);
    options.retry_after_min = options.retry_after_max = retry_after;
    link_ = std::make_unique<SessionLink>(connection_, options);
    EXPECT_TRUE(until([this] { return welcomes == 1; }));
  }

  void slide(const std::string& id, double beta) {
    EXPECT_TRUE(link_->apply({{id, SetGradientScale{beta}}}).is_ok());
  }

  template <typename What>
  bool until(What what) {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (std::chrono::steady_clock::now() < end) {
      listen();
      if (what()) return true;
      std::this_thread::sleep_for(milliseconds(2));
    }
    return false;
  }

  int welcomes = 0;
  bool is_live = false;
  std::vector<EditsAcknowledged> answers;
  size_t refusals = 0;

 private:
  void listen() {
    const LiveNews news = link_->take();
    is_live = news.link == LinkState::kLive;
    for (const LiveEvent& event : news.events) {
      welcomes += std::holds_alternative<Welcome>(event);
      refusals += std::holds_alternative<EditsRefused>(event);
      if (const auto* answer = std::get_if<EditsAcknowledged>(&event)) answers.push_back(*answer);
    }
  }

  Connection connection_;
  FetchedPages pages_;
  std::unique_ptr<SessionLink> link_;
};

/// A server whose next sync after SIGUSR1 is done and fails.
class DoubtTest : public testing::Test {
 protected:
  void SetUp() override {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "the sanitizer's library must be loaded first";
#endif
    ::setenv("LD_PRELOAD", DIE_AT_LIBRARY, 1);
    ::setenv("BURNISH_DIE_AT", "failed sync", 1);
    ::setenv("BURNISH_DIE_COUNT", "1", 1);
    server_ = std::make_unique<ServerProcess>();
    ::unsetenv("LD_PRELOAD");
    server_->listen = server_->address;
    EXPECT_EQ(burnish({"import", write_sphere(server_->folder), "--depth", "4", "--name", "ball"}),
              0);
    EXPECT_EQ(burnish({"open", "ball", "--depth", "4", "--session", "work"}), 0);
  }

  int burnish(std::vector<std::string> words) {
    return server_->burnish(std::move(words)).exit_code;
  }

  std::vector<std::string> history() {
    std::vector<std::string> ids;
    Connection connection = Connection::open(server_->address, kPatience).value();
    const std::vector<HistoryEntry> entries = connection.history("work").value();
    for (const HistoryEntry& entry : entries) ids.push_back(entry.edit_id);
    return ids;
  }

  std::unique_ptr<ServerProcess> server_;
};

TEST_F(DoubtTest, AnEditInDoubtComesAgainAndIsThereOnce) {
  DoubtingClient ann(server_->address, "ann", milliseconds(20));
  DoubtingClient bob(server_->address, "bob", milliseconds(20));
  ann.slide("a", 0.5);
  EXPECT_TRUE(ann.until([&] { return ann.answers.size() == 1; }));
  server_->arm_fault();
  ann.slide("b", 2);
  EXPECT_TRUE(ann.until([&] { return ann.answers.size() == 2; }));
  EXPECT_GE(ann.welcomes, 2);
  EXPECT_EQ(ann.refusals, 0u);
  EXPECT_TRUE(bob.until([&] { return bob.welcomes >= 2 && bob.is_live; }));
  EXPECT_THAT(history(), ElementsAre("a", "b"));
}

TEST_F(DoubtTest, ACommitInDoubtThatSurvivesACrashIsKnownWhenItsEditComesAgain) {
  // The server is gone before she comes back, on a slow machine too.
  DoubtingClient ann(server_->address, "ann", milliseconds(15'000));
  ann.slide("a", 0.5);
  EXPECT_TRUE(ann.until([&] { return ann.answers.size() == 1; }));
  server_->arm_fault();
  ann.slide("b", 2);
  EXPECT_TRUE(ann.until([&] { return !ann.is_live; }));
  server_->kill();
  server_->start();
  EXPECT_TRUE(ann.until([&] { return ann.answers.size() == 2; }));
  EXPECT_EQ(ann.answers.back().outcome.known, 1u);
  EXPECT_THAT(history(), ElementsAre("a", "b"));
}

}  // namespace
}  // namespace burnish
