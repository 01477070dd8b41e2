#include "server/manager/session_manager.h"

#include <algorithm>
#include <future>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/journal/sqlite_journal.h"
#include "server/library/scan_record.h"
#include "server/manager/cell_values.h"
#include "tests/server/manager/test_library.h"

namespace burnish {
namespace {

using testing::HasSubstr;

/// A library with one scan, "ball", and a manager that can be restarted.
class SessionManagerTest : public testing::Test {
 protected:
  SessionManagerTest() {
    scan_id_ = library_.import(sphere_file(), "ball").value().scan.id;
    options_.kept.sessions_max = 3;
    options_.solver.threads = 1;
    start();
  }

  void start() {
    manager_.reset();
    journal_.reset();
    library_.restart();
    journal_ = std::move(SqliteJournal::open(library_.folder->journal())).value();
    manager_ =
        std::move(SessionManager::create(*library_.folder, *library_.store, *journal_, options_))
            .value();
  }

  Result<OpenedSession> open(const std::string& name, int depth = 5) {
    return manager_->open({"ball", name, {depth, 0}}, user_, {});
  }

  Result<ApplyOutcome> apply(const std::string& session, const std::vector<Edit>& edits) {
    return manager_->apply(session, user_, edits, {});
  }

  std::string exported(const std::string& session) {
    const auto file = manager_->export_mesh(session, {MeshFormat::kPly, false, 3}, {});
    return file.is_ok() ? file.value()->read(0).value() : file.status().to_string();
  }

  TestLibrary library_;
  SessionManagerOptions options_;
  std::unique_ptr<Journal> journal_;
  std::unique_ptr<SessionManager> manager_;
  std::string scan_id_;
  std::string user_;  // opens, edits and removes
};

TEST_F(SessionManagerTest, AnOpenSessionHasTheHierarchyOfItsScanKept) {
  const auto kept = library_.folder->scans() / scan_id_ / "prepared" / hierarchy_file_name({5, 0});
  EXPECT_FALSE(std::filesystem::exists(kept));
  ASSERT_TRUE(open("one").is_ok());
  while (!std::filesystem::exists(kept)) std::this_thread::yield();  // its thread has low priority
}

TEST_F(SessionManagerTest, OpeningTheSameNameAgainAttaches) {
  const auto first = open("one");
  ASSERT_TRUE(first.is_ok()) << first.status().message();
  EXPECT_FALSE(first.value().attached);
  EXPECT_EQ(first.value().session.key.depth, 5);
  EXPECT_TRUE(open("one").value().attached);
  EXPECT_EQ(manager_->list().size(), 1u);
}

TEST_F(SessionManagerTest, ANameOfAnotherDepthIsTaken) {
  ASSERT_TRUE(open("one", 5).is_ok());
  EXPECT_EQ(open("one", 6).status().code(), StatusCode::kAlreadyExists);
}

TEST_F(SessionManagerTest, SessionsBeyondTheLimitAreRefusedWithTheNumbers) {
  for (const char* name : {"1", "2", "3"}) ASSERT_TRUE(open(name).is_ok());
  const Status status = open("4").status();
  EXPECT_EQ(status.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(status.message(), HasSubstr("limits.sessions_max is 3"));
}

TEST_F(SessionManagerTest, ARenamedSessionKeepsItsEditsAndFreesItsOldName) {
  const std::string id = open("one")->session.id;
  ASSERT_TRUE(apply("one", {{"a", SetGradientScale{0.5}}}).is_ok());
  const auto renamed = manager_->rename("one", "two", {});
  ASSERT_TRUE(renamed.is_ok()) << renamed.status().message();
  EXPECT_EQ(renamed->name, "two");
  EXPECT_EQ(renamed->id, id);
  EXPECT_EQ(manager_->state("two", {})->settings.beta, 0.5);
  EXPECT_EQ(manager_->state("one", {}).status().code(), StatusCode::kNotFound);
  start();
  ASSERT_EQ(manager_->list().size(), 1u);
  EXPECT_EQ(manager_->list()[0].name, "two");
  EXPECT_EQ(manager_->state("two", {})->settings.beta, 0.5);
  EXPECT_FALSE(open("one")->attached);
}

TEST_F(SessionManagerTest, ASessionIsNotRenamedToATakenNameOrToAnId) {
  ASSERT_TRUE(open("one").is_ok() && open("two").is_ok());
  EXPECT_EQ(manager_->rename("one", "two", {}).status().code(), StatusCode::kAlreadyExists);
  EXPECT_EQ(manager_->rename("one", "0123456789abcdef", {}).status().code(),
            StatusCode::kInvalidArgument);
  EXPECT_EQ(manager_->rename("none", "three", {}).status().code(), StatusCode::kNotFound);
  EXPECT_TRUE(manager_->rename("one", "one", {}).is_ok());
  EXPECT_EQ(manager_->list()[0].name, "one");
}

TEST_F(SessionManagerTest, AnEditIdAppliedTwiceChangesOnce) {
  ASSERT_TRUE(open("one").is_ok());
  const std::vector<Edit> edits = {{"a", SetGradientScale{0.5}}, {"b", SetGradientScale{0.25}}};
  EXPECT_EQ(apply("one", edits).value().applied, 2u);
  const ApplyOutcome again = apply("one", edits).value();
  EXPECT_EQ(again.applied, 0u);
  EXPECT_EQ(again.known, 2u);
  EXPECT_EQ(again.edits, 2u);
}

TEST_F(SessionManagerTest, AFailedEditInABatchUndoesTheWholeBatch) {
  ASSERT_TRUE(open("one").is_ok());
  ASSERT_TRUE(apply("one", {{"a", SetGradientScale{0.5}}}).is_ok());
  const SetCellFields nowhere{{{Vec3i(0, 0, 0), 5, 5, 1}}};
  const auto outcome = apply("one", {{"b", SetGradientScale{2}}, {"c", nowhere}});
  EXPECT_EQ(outcome.status().code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(outcome.status().message(), HasSubstr("edit c"));
  const SessionState state = manager_->state("one", {}).value();
  EXPECT_EQ(state.settings.beta, 0.5);
  EXPECT_EQ(state.session.edits, 1u);
}

TEST_F(SessionManagerTest, KeptEdgesAreInTheStateAndComeBackWithTheSession) {
  ASSERT_TRUE(open("one").is_ok());
  const EdgeFilter filter{.strength = 0.5, .passes = 3};
  ASSERT_TRUE(apply("one", {{"a", SetEdges{filter}}}).is_ok());
  EXPECT_EQ(manager_->state("one", {})->settings.edges, filter);
  const std::string before = exported("one");
  start();
  EXPECT_EQ(manager_->state("one", {})->settings.edges, filter);
  EXPECT_EQ(exported("one"), before);
}

TEST_F(SessionManagerTest, KeptEdgesThatDoNotFitAreRefusedAndNotStored) {
  ASSERT_TRUE(open("one").is_ok());
  Quota& memory = manager_->memory();
  const Quota::Share rest = memory.take(kServer, memory.max() - memory.taken() - 100'000).value();
  const auto outcome = apply("one", {{"a", SetEdges{{.strength = 1}}}});
  EXPECT_EQ(outcome.status().code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(outcome.status().message(), HasSubstr("limits.memory_bytes_max"));
  EXPECT_EQ(journal_->edit_count(manager_->list()[0].id).value(), 0u);
  EXPECT_TRUE(apply("one", {{"b", SetEdges{{.strength = 0}}}}).is_ok());
}

TEST_F(SessionManagerTest, BandsAndAVolumeAreRefusedBesideKeptEdgesInEitherOrder) {
  const SetEdges edges{{.strength = 1}};
  const SetEqualiser bands{{{{0.5, 2}}}};
  const SetControls volume{{.keep_volume = true}};
  ASSERT_TRUE(open("one").is_ok() && open("two").is_ok() && open("three").is_ok());
  ASSERT_TRUE(apply("one", {{"a", edges}}).is_ok());
  ASSERT_TRUE(apply("two", {{"a", bands}}).is_ok());
  ASSERT_TRUE(apply("three", {{"a", volume}}).is_ok());
  const std::pair<const char*, Change> refused[] = {
      {"one", bands}, {"one", volume}, {"two", edges}, {"three", edges}};
  for (const auto& [session, change] : refused) {
    const Status status = apply(session, {{"b", change}}).status();
    EXPECT_EQ(status.code(), StatusCode::kFailedPrecondition) << session;
    EXPECT_THAT(status.message(), HasSubstr("kept")) << session;
  }
}

TEST_F(SessionManagerTest, ACellThatAnEditSetsTwiceIsRefusedAndNotStored) {
  ASSERT_TRUE(open("one").is_ok());
  const auto mesh = library_.store->open_mesh(scan_id_, {5, 0}, {}).value();
  const Vec3i cell = morton_point(mesh->prepared->cells[0]);
  const auto setting = [&](size_t times) {
    return Edit{"cells", SetCellFields{std::vector<SetCellFields::Cell>(times, {cell, 5, 5, 2})}};
  };
  EXPECT_THAT(apply("one", {setting(2)}).status().message(), HasSubstr("twice"));
  EXPECT_THAT(apply("one", {setting(mesh->prepared->cells.size() + 1)}).status().message(),
              HasSubstr("the limit is " + std::to_string(mesh->prepared->cells.size())));
  EXPECT_EQ(journal_->edit_count(manager_->list()[0].id).value(), 0u);
  EXPECT_TRUE(apply("one", {setting(1)}).is_ok());
}

TEST_F(SessionManagerTest, AForkAtAnotherDepthHasAllEditsButSetsNoSingleCells) {
  ASSERT_TRUE(open("one").is_ok());
  const auto mesh = library_.store->open_mesh(scan_id_, {5, 0}, {}).value();
  const SetCellFields cells{{{morton_point(mesh->prepared->cells[0]), 5, 5, 2}}};
  const Stroke stroke{{.radius = 0.3, .beta = 2}, {Vec3d(0, 0, 1)}};
  ASSERT_TRUE(apply("one", {{"a", stroke}, {"b", cells}, {"c", SetGradientScale{0.5}}}).is_ok());
  const ForkedSession deeper = manager_->fork({"one", "deeper", 0, "", 6}, user_).value();
  EXPECT_EQ(deeper.session.key.depth, 6);
  EXPECT_EQ(deeper.session.edits, 3u);
  EXPECT_EQ(deeper.emptied_edits, 1u);
  EXPECT_EQ(manager_->state("deeper", {}).value().settings.beta, 0.5);
  const auto check = [](Session& session) {
    EXPECT_GT(std::ranges::max(cell_values(session, CellValue::kBeta)), 1.5f);  // of the stroke
    return Status::ok();
  };
  EXPECT_TRUE(manager_->visit("deeper", user_, check, {}).is_ok());
  EXPECT_EQ(manager_->fork({"one", "same", 0, "", 0}, user_).value().emptied_edits, 0u);
}

TEST_F(SessionManagerTest, EditsCountInTheMemoryOfTheirSession) {
  ASSERT_TRUE(open("one").is_ok());
  const uint64_t before = manager_->usage().session_bytes;
  const Stroke stroke{{.radius = 10}, std::vector<Vec3d>(4000, Vec3d(1, 0, 0))};
  ASSERT_TRUE(apply("one", {{"a", stroke}, {"b", stroke}}).is_ok());
  EXPECT_GE(manager_->usage().session_bytes, before + 2 * 4000 * sizeof(Vec3d));
  start();
  ASSERT_TRUE(open("one").is_ok());
  EXPECT_GE(manager_->usage().session_bytes, before + 2 * 4000 * sizeof(Vec3d));
}

TEST_F(SessionManagerTest, AnEditForWhichThereIsNoMemoryIsRefused) {
  ASSERT_TRUE(open("one").is_ok());
  Quota& memory = manager_->memory();
  const auto rest = memory.take(kServer, memory.max() - memory.taken() - 10'000);
  const Stroke stroke{{.radius = 10}, std::vector<Vec3d>(4000, Vec3d(1, 0, 0))};
  const Status status = apply("one", {{"a", stroke}}).status();
  EXPECT_EQ(status.code(), StatusCode::kResourceExhausted);
  EXPECT_TRUE(apply("one", {{"b", SetGradientScale{0.5}}}).is_ok());
}

TEST_F(SessionManagerTest, ARestartedServerBringsBackTheSameSurface) {
  ASSERT_TRUE(open("one").is_ok());
  const Stroke stroke{{0.5, 1, 2, FallOff::kSmooth}, {Vec3d(0, 0, 1), Vec3d(0, 0.3, 0.95)}};
  ASSERT_TRUE(apply("one", {{"a", SetTransferCurve{TransferCurve(5)}},
                            {"b", SetGradientScale{0.25}},
                            {"c", stroke}})
                  .is_ok());
  const std::string before = exported("one");
  start();
  ASSERT_EQ(manager_->list().size(), 1u);
  EXPECT_EQ(manager_->list()[0].edits, 3u);
  EXPECT_FALSE(manager_->list()[0].in_memory);
  EXPECT_EQ(exported("one"), before);
  EXPECT_THAT(before, testing::StartsWith("ply"));
}

TEST_F(SessionManagerTest, AClosedSessionKeepsItsEdits) {
  ASSERT_TRUE(open("one").is_ok());
  ASSERT_TRUE(apply("one", {{"a", SetGradientScale{0.5}}}).is_ok());
  ASSERT_TRUE(manager_->close("one", user_, {}).is_ok());
  EXPECT_FALSE(manager_->list()[0].in_memory);
  EXPECT_EQ(manager_->state("one", {}).value().settings.beta, 0.5);
  EXPECT_EQ(apply("one", {{"a", SetGradientScale{0.7}}}).value().known, 1u);
}

TEST_F(SessionManagerTest, ARemovedSessionIsGoneForGood) {
  ASSERT_TRUE(open("one").is_ok());
  ASSERT_TRUE(manager_->remove("one", user_, {}).is_ok());
  EXPECT_EQ(manager_->state("one", {}).status().code(), StatusCode::kNotFound);
  start();
  EXPECT_TRUE(manager_->list().empty());
}

TEST_F(SessionManagerTest, AScanThatIsEditedCannotBeDeleted) {
  ASSERT_TRUE(open("one").is_ok());
  const auto refused = manager_->delete_scan("ball");
  EXPECT_EQ(refused.status().code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(refused.status().message(), HasSubstr("session one"));
  ASSERT_TRUE(manager_->remove("one", user_, {}).is_ok());
  EXPECT_EQ(manager_->delete_scan("ball").value(), scan_id_);
}

TEST_F(SessionManagerTest, ASessionThatCannotBeOpenedIsNotKept) {
  const auto refused =
      manager_->open({"ball", "one", {6, 0}}, "", [](std::string_view, double) { return false; });
  EXPECT_EQ(refused.status().code(), StatusCode::kCancelled);
  EXPECT_TRUE(manager_->list().empty());
}

TEST_F(SessionManagerTest, ANameThatCouldBeAnIdIsRefused) {
  ASSERT_TRUE(open("one").is_ok());
  const std::string id = manager_->list()[0].id;
  for (const std::string& name : {id, std::string("0123456789ABCDEF")}) {
    const Status refused = open(name).status();
    EXPECT_EQ(refused.code(), StatusCode::kInvalidArgument);
    EXPECT_THAT(refused.message(), HasSubstr("session name '" + name + "'"));
    EXPECT_EQ(manager_->fork({"one", name, 0, ""}, user_).status().code(),
              StatusCode::kInvalidArgument);
  }
  EXPECT_TRUE(open("0123456789abcde").is_ok());
}

TEST_F(SessionManagerTest, AnIdMeansItsSessionWhateverOthersAreCalled) {
  ASSERT_TRUE(open("one").is_ok());
  const SessionInfo one = manager_->list()[0];
  // The journal of an older program may have such a name.
  const SessionRecord forged{"f00", one.id, one.scan_id, one.key, 0};
  ASSERT_TRUE(journal_->create_session(forged, {}).is_ok());
  start();
  ASSERT_TRUE(apply(one.id, {{"a", SetGradientScale{0.5}}}).is_ok());
  EXPECT_EQ(manager_->state("one", {}).value().settings.beta, 0.5);
  EXPECT_EQ(manager_->state("f00", {}).value().settings.beta, 1);
}

TEST_F(SessionManagerTest, WhoGivesUpOpeningTakesNothingFromWhoWaits) {
  // The first opener gives up when the second waits for its session.
  std::promise<void> waits;
  std::thread second;
  Result<OpenedSession> opened = internal_error("not opened");
  const Progress tell_that_it_waits = [&, told = false](std::string_view phase, double) mutable {
    if (phase == "waiting for the session" && !std::exchange(told, true)) waits.set_value();
    return true;
  };
  const auto give_up = [&](std::string_view, double) {
    if (!second.joinable()) {
      second = std::thread([&] {
        opened = manager_->open({"ball", "team", {6, 0}}, "bob", tell_that_it_waits);
      });
      waits.get_future().wait();
    }
    return false;
  };
  EXPECT_EQ(manager_->open({"ball", "team", {6, 0}}, "ann", give_up).status().code(),
            StatusCode::kCancelled);
  ASSERT_TRUE(second.joinable());
  second.join();
  ASSERT_TRUE(opened.is_ok()) << opened.status().message();
  EXPECT_FALSE(opened.value().attached);
  ASSERT_TRUE(apply("team", {{"a", SetGradientScale{0.5}}}).is_ok());
  start();
  ASSERT_EQ(manager_->list().size(), 1u);
  EXPECT_EQ(manager_->list()[0].edits, 1u);
}

TEST_F(SessionManagerTest, SessionsAreListedWhileTheDiskHoldsUpANewOne) {
  ASSERT_TRUE(open("one").is_ok());
  std::promise<void> disk;
  journal_->append(manager_->list()[0].id, 1, {},
                   [&](const WriteOutcome&) { disk.get_future().wait(); });
  std::thread opener([&] { EXPECT_TRUE(open("two").is_ok()); });
  std::thread forker([&] { EXPECT_TRUE(manager_->fork({"one", "three", 0, ""}, "").is_ok()); });
  EXPECT_EQ(manager_->list().size(), 1u);
  disk.set_value();
  opener.join();
  forker.join();
  EXPECT_EQ(manager_->list().size(), 3u);
}

TEST_F(SessionManagerTest, EditsThatCouldNotBeWrittenAreNotCounted) {
  ASSERT_TRUE(open("one").is_ok());
  ASSERT_TRUE(apply("one", {{"a", SetGradientScale{0.5}}}).is_ok());
  const std::string id = manager_->list()[0].id;
  ASSERT_TRUE(journal_->append(id, 2, {{"eve", 0, {"x", SetGradientScale{2}}}}).is_on_disk());
  EXPECT_FALSE(apply("one", {{"b", SetGradientScale{0.25}}}).is_ok());
  ASSERT_TRUE(manager_->close("one", user_).is_ok());
  EXPECT_EQ(manager_->list()[0].edits, 1u);
}

/// Returns a user whom a server with users has let in.
Caller admitted(const std::string& name, bool owns_server = false) {
  Caller caller(name);
  caller.is_admitted = true;
  caller.owns_server = owns_server;
  return caller;
}

TEST_F(SessionManagerTest, KeptSessionsHaveAShareForEachUserForksIncluded) {
  options_.kept.sessions_max = 20;
  options_.kept.sessions_per_user = 2;
  start();
  const Caller mallory = admitted("mallory");
  ASSERT_TRUE(manager_->open({"ball", "1", {5, 0}}, mallory, {}).is_ok());
  ASSERT_TRUE(manager_->fork({.source = "1", .name = "2"}, mallory).is_ok());
  for (int life = 0; life < 2; ++life) {
    const Status refused = manager_->fork({.source = "1", .name = "3"}, mallory).status();
    EXPECT_EQ(refused.code(), StatusCode::kResourceExhausted);
    EXPECT_THAT(refused.message(), HasSubstr("user mallory has 2 sessions"));
    EXPECT_THAT(refused.message(), HasSubstr("limits.kept_sessions_per_user is 2"));
    EXPECT_TRUE(manager_->open({"ball", "1", {5, 0}}, mallory, {}).value().attached);
    start();  // those in the journal count as well
  }
  EXPECT_EQ(manager_->largest_share().sessions, 2u);
  EXPECT_TRUE(manager_->fork({.source = "1", .name = "b"}, admitted("bert")).is_ok());
  EXPECT_TRUE(manager_->fork({.source = "1", .name = "n"}, Caller("nobody known")).is_ok());
  ASSERT_TRUE(manager_->remove("2", mallory).is_ok());
  EXPECT_TRUE(manager_->fork({.source = "1", .name = "3"}, mallory).is_ok());
}

TEST_F(SessionManagerTest, ASessionStaysItsMakersWhoeverElseGetsToOwnIt) {
  options_.kept.sessions_per_user = 1;
  start();
  const Caller mallory = admitted("mallory");
  ASSERT_TRUE(manager_->open({"ball", "1", {5, 0}}, mallory, {}).is_ok());
  ASSERT_TRUE(manager_->set_role("1", mallory, "ghost", SessionRole::kOwner).is_ok());
  ASSERT_TRUE(manager_->set_role("1", mallory, "mallory", SessionRole::kViewer).is_ok());
  for (int life = 0; life < 2; ++life) {
    EXPECT_EQ(manager_->open({"ball", "2", {5, 0}}, mallory, {}).status().code(),
              StatusCode::kResourceExhausted);
    EXPECT_TRUE(manager_->fork({.source = "1"}, admitted("ghost")).is_ok());
    ASSERT_TRUE(manager_->remove(manager_->list().back().name, admitted("ghost")).is_ok());
    start();  // the journal keeps the maker
  }
}

TEST_F(SessionManagerTest, ASessionOfAnOlderJournalCountsForItsFirstOwner) {
  ASSERT_TRUE(open("one").is_ok());
  const SessionInfo one = manager_->list()[0];
  const SessionRecord old{"old", "old", one.scan_id, one.key, 0};
  ASSERT_TRUE(journal_->create_session(old, SessionRoles::of_new_session("ann")).is_ok());
  options_.kept.sessions_per_user = 1;
  start();
  const Status refused = manager_->fork({.source = "one"}, admitted("ann")).status();
  EXPECT_THAT(refused.message(), HasSubstr("user ann has 1 sessions"));
}

TEST_F(SessionManagerTest, TheLastPlacesAreForOwnersOfTheServer) {
  options_.kept.sessions_max = 4;
  options_.kept.sessions_for_owners = 1;
  start();
  for (const char* name : {"1", "2", "3"})
    ASSERT_TRUE(
        manager_->open({"ball", name, {5, 0}}, admitted("u" + std::string(name)), {}).is_ok());
  const Status refused = manager_->open({"ball", "4", {5, 0}}, admitted("ann"), {}).status();
  EXPECT_EQ(refused.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(refused.message(), HasSubstr("limits.sessions_max is 4, and its last 1 places"));
  EXPECT_THAT(refused.message(), HasSubstr("limits.sessions_for_owners"));
  EXPECT_TRUE(manager_->open({"ball", "4", {5, 0}}, admitted("olga", true), {}).is_ok());
}

TEST_F(SessionManagerTest, AFullHistoryRefusesEditsAndTakesUndo) {
  options_.kept.history_bytes_per_session = 5'000;
  start();
  const Caller mallory = admitted("mallory");
  ASSERT_TRUE(manager_->open({"ball", "1", {5, 0}}, mallory, {}).is_ok());
  const auto try_edit = [&](int number, decltype(Edit::change) change, const Caller& who) {
    const std::vector<Edit> edits = {{"e" + std::to_string(number), std::move(change)}};
    return manager_->apply("1", who, edits).status();
  };
  int number = 0;
  Status status;
  while (status.is_ok() && number < 100)
    status = try_edit(++number, SetCheckpoint{"here"}, mallory);
  EXPECT_EQ(status.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(status.message(), HasSubstr("limits.history_bytes_per_session is 5000"));
  EXPECT_LT(number, 12);
  EXPECT_EQ(try_edit(200, SetGradientScale{0.5}, mallory).code(), StatusCode::kResourceExhausted);
  EXPECT_TRUE(try_edit(201, RestoreCheckpoint{"here"}, mallory).is_ok());
  EXPECT_TRUE(try_edit(202, SetGradientScale{0.5}, admitted("olga", true)).is_ok());
  EXPECT_TRUE(manager_->remove("1", mallory).is_ok());
}

TEST_F(SessionManagerTest, HistoriesOfAllSessionsOfAUserHaveALimitForksIncluded) {
  options_.kept.sessions_max = 20;
  options_.kept.history_bytes_per_user = 5'000;
  start();
  const Caller mallory = admitted("mallory");
  ASSERT_TRUE(manager_->open({"ball", "1", {5, 0}}, mallory, {}).is_ok());
  for (const char* id : {"a", "b", "c", "d"}) {
    const std::vector<Edit> edits = {{id, SetGradientScale{0.5}}};
    ASSERT_TRUE(manager_->apply("1", mallory, edits).is_ok());
  }
  for (int life = 0; life < 2; ++life) {
    const Status refused = manager_->fork({.source = "1", .name = "2"}, mallory).status();
    EXPECT_EQ(refused.code(), StatusCode::kResourceExhausted);
    EXPECT_THAT(refused.message(), HasSubstr("user mallory has "));
    EXPECT_THAT(refused.message(), HasSubstr("limits.history_bytes_per_user is 5000"));
    start();
  }
  EXPECT_GT(manager_->largest_share().history_bytes, 2'500u);
  EXPECT_TRUE(manager_->fork({.source = "1", .name = "2"}, admitted("bert")).is_ok());
}

TEST_F(SessionManagerTest, WhoBringsASessionBackIsChargedForIt) {
  options_.sessions_per_user = 1;
  start();
  for (const char* name : {"1", "2"}) ASSERT_TRUE(open(name).is_ok());
  start();
  EXPECT_TRUE(manager_->state("1", "vera").is_ok());
  EXPECT_TRUE(manager_->state("1", "vera").is_ok());
  const Status refused = manager_->state("2", "vera").status();
  EXPECT_EQ(refused.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(refused.message(), HasSubstr("user vera has 1 sessions open"));
  EXPECT_TRUE(manager_->state("2", "bert").is_ok());
}

TEST_F(SessionManagerTest, ACancelledExportLeavesNoFile) {
  ASSERT_TRUE(open("one").is_ok());
  ASSERT_TRUE(apply("one", {{"a", SetGradientScale{0}}}).is_ok());
  const auto cancelled = manager_->export_mesh("one", {MeshFormat::kPly, true, 0}, {},
                                               [](std::string_view, double) { return false; });
  EXPECT_EQ(cancelled.status().code(), StatusCode::kCancelled);
  EXPECT_EQ(library_.staged_files(), 0u);
}

TEST_F(SessionManagerTest, AnExportFileHasNoNameAndTellsItsHash) {
  ASSERT_TRUE(open("one").is_ok());
  const auto file =
      std::move(manager_->export_mesh("one", {MeshFormat::kStl, false, 1}, {})).value();
  EXPECT_EQ(library_.staged_files(), 0u);
  EXPECT_EQ(file->summary().triangles, 1280u);
  EXPECT_EQ(file->summary().size_bytes, 84u + 50u * 1280u);
  EXPECT_EQ(file->summary().sha256.size(), 64u);
  EXPECT_TRUE(file->read(file->summary().size_bytes).value().empty());
}

}  // namespace
}  // namespace burnish
