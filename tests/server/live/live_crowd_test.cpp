// Many clients at once, each on its own thread, at sessions that solve on their own threads.

#include <random>
#include <set>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/journal/sqlite_journal.h"
#include "tests/server/live/live_guest.h"
#include "tests/server/manager/test_library.h"

namespace burnish {
namespace {

constexpr int kVisitsEach = 6;
constexpr int kDeedsEach = 40;

/// A person who comes, does things at random, and goes: sometimes without a word, sometimes after
/// waiting for all answers.
class Visitor {
 public:
  Visitor(SessionManager& manager, LiveSessions& live, int number)
      : manager_(manager), live_(live), name_("user" + std::to_string(number)), random_(number) {}

  void come_and_go() {
    for (int visit = 0; visit < kVisitsEach; ++visit) {
      LiveGuest guest(live_, manager_.store(), {pick(2) ? "one" : "two", kinds_[pick(3)]}, name_);
      shown_.clear();
      for (int deed = 0; deed < kDeedsEach && !guest.finished; ++deed) {
        do_something(guest);
        guest.take_all();
      }
      if (visit % 2 == 0) hear_all(guest);
      acknowledged += count(guest.all<EditsAcknowledged>());
    }
  }

  uint64_t acknowledged = 0;  // new edits

 private:
  int pick(int n) { return std::uniform_int_distribution(0, n - 1)(random_); }
  std::string new_id() { return "edit" + std::to_string(++last_id_); }
  Stroke stroke() {
    const double angle = 0.1 * pick(60);
    return {{0.4, 0.5, 0.3, FallOff::kSmooth}, {{std::cos(angle), std::sin(angle), 0}}};
  }
  void show_or_hide(LiveGuest& guest, PageId page) {
    if (guest.pages.newest_revision() - guest.pages.revision() >= kPageChangesInFlightMax) return;
    if (shown_.erase(page) > 0) return guest.show({}, {page});
    shown_.insert(page);
    guest.show({page});
  }
  static void hear_all(LiveGuest& guest) {
    guest.subscriber().close(std::nullopt);
    for (; !guest.finished; guest.take_all()) std::this_thread::yield();
  }
  static uint64_t count(const std::vector<EditsAcknowledged>& answers) {
    uint64_t sum = 0;
    for (const EditsAcknowledged& answer : answers) sum += answer.outcome.applied;
    return sum;
  }

  void do_something(LiveGuest& guest) {
    const uint64_t connection = guest.connection();
    switch (pick(11)) {
      case 0:
        return guest.edit({{new_id(), SetGradientScale{0.1 * pick(20)}}, {new_id(), stroke()}});
      case 1:
        return guest.edit({{new_id(), Undo{}}});
      case 2:
        return (void)guest.session().preview(connection, {"drag", stroke()});
      case 3:
        return (void)guest.session().preview(connection, {"slide", SetGradientScale{0.5}});
      case 4:
        return guest.session().drop_preview(connection, "drag");
      case 5:
        return guest.session().move_brush(connection, BrushRing{{0, 0, 0.1 * pick(9)}, 1});
      case 6:
        return guest.subscriber().beat(static_cast<uint64_t>(pick(1000)));
      case 7:
      case 8:
        return show_or_hide(guest, static_cast<PageId>(pick(guest.pages.head().page_count())));
      case 9:
        if (pick(10) == 0) (void)manager_.close(pick(2) ? "one" : "two", name_, {});
        return;
      default:
        guest.subscriber().grant({.frames = 2, .decoded = std::exchange(guest.decoded, {})});
    }
  }

  SessionManager& manager_;
  LiveSessions& live_;
  const std::string name_;
  const std::optional<PageFrameKind> kinds_[3] = {std::nullopt, PageFrameKind::kVertices,
                                                  PageFrameKind::kCorners};
  std::mt19937_64 random_;
  std::set<PageId> shown_;  // at this visit
  int last_id_ = 0;
};

TEST(LiveCrowd, LeavesWhatAPlainReplayGivesAndNothingElse) {
  TestLibrary library;
  ASSERT_TRUE(library.import(sphere_file(1, 5), "ball").is_ok());
  const auto journal = std::move(SqliteJournal::open(library.folder->journal())).value();
  SessionManagerOptions options;
  options.solver.backend = BackendKind::kCpu;
  options.solver.threads = 1;
  const auto manager =
      std::move(SessionManager::create(*library.folder, *library.store, *journal, options)).value();
  for (const char* name : {"one", "two"})
    ASSERT_TRUE(manager->open({"ball", name, {4, 0}}, "", {}).is_ok());

  std::vector<std::unique_ptr<Visitor>> visitors;
  {
    LiveSessions live(*manager, 2);
    std::vector<std::thread> threads;
    for (int i = 0; i < 6; ++i) {
      visitors.push_back(std::make_unique<Visitor>(*manager, live, i));
      threads.emplace_back([visitor = visitors.back().get()] { visitor->come_and_go(); });
    }
    for (std::thread& thread : threads) thread.join();
  }

  uint64_t acknowledged = 0, kept = 0;
  for (const auto& visitor : visitors) acknowledged += visitor->acknowledged;
  for (const SessionInfo& session : manager->list()) {
    EXPECT_TRUE(manager
                    ->visit(session.id, {},
                            [&](Session& live) {
                              const auto edits = journal->edits(session.id).value();
                              EditedFields plain(live.prepared());
                              EXPECT_TRUE(plain.apply(edits).is_ok());
                              EXPECT_EQ(live.fields().painted(), plain.fields().painted());
                              EXPECT_EQ(live.fields().gradient_scale(),
                                        plain.fields().gradient_scale());
                              kept += edits.size();
                              return Status::ok();
                            })
                    .is_ok());
  }
  // Only now: reading the journal has waited for the last answers.
  EXPECT_EQ(live_count(LiveKind::kStream), 0);
  EXPECT_EQ(live_count(LiveKind::kLiveSession), 0);
  EXPECT_GT(acknowledged, 0u);
  EXPECT_GE(kept, acknowledged);  // some left before their answer
}

}  // namespace
}  // namespace burnish
