// Kills the server with -9 under editing load, while other clients open sessions and give up, ask
// for names that are ids, and idle sessions leave memory. No acknowledged edit may be lost or
// counted twice, every client must come back, and no file may be damaged.
// BURNISH_KILL_ROUNDS=N kills N times instead of 5; BURNISH_KILL_VERTICES=N edits a generated scan
// of that size.

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "server/journal/sqlite.h"
#include "server/prepare/prepared_mesh.h"
#include "tests/system/environment.h"
#include "tests/system/restless_editor.h"
#include "tests/system/restless_openers.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr int kRoundsPerServer = 20;  // then a new data folder, so that histories stay short
const std::vector<std::string> kSessions = {"one", "two", "three"};
constexpr int kEditors = 5;  // shared out to the sessions in turn

struct Return {
  double listening_s, back_s;  // since the start of the new process
  size_t edits;                // edits in the histories of all sessions
  size_t forks;                // of a session that was edited
  size_t races;                // races: two clients opened one new session, and the second was told
};

double seconds_since(Clock::time_point then) {
  return std::chrono::duration<double>(Clock::now() - then).count();
}

/// A data folder and its server, which is killed again and again.
class KilledServer {
 public:
  KilledServer(int vertices, uint32_t seed) : random_(seed) {
    spill_soon();
    TriangleMesh mesh = generate_scan({"tablet", static_cast<uint64_t>(vertices), seed}).value();
    mesh.colours.assign(mesh.vertices.size(), {200, 120, 60, 255});
    const fs::path scan = server_.folder / "scan.ply";
    EXPECT_TRUE(write_mesh(mesh, scan).is_ok());
    EXPECT_TRUE(connect().import_scan(scan, "scan", {}, {}).is_ok());
    EditorPlace place{.address = server_.address,
                      .brush_radius = 0.05 * mesh.vertices.front().norm()};
    for (int i = 0; i < 50; ++i)
      place.surface.push_back(mesh.vertices[random_() % mesh.vertices.size()]);
    Connection connection = connect();
    place.pages = fetch_all_pages(connection, "scan");
    for (const std::string& session : kSessions)
      place.depth = connection.open_session({"scan", session}).value().session.key.depth;
    for (int i = 0; i < kEditors; ++i) {
      place.session = kSessions[i % kSessions.size()];
      place.has_bands = place.session == kSessions.front();
      editors_[place.session].push_back(
          std::make_unique<RestlessEditor>(place, "user" + std::to_string(i), random_()));
    }
    server_.listen = server_.address;
    openers_ = std::make_unique<RestlessOpeners>(server_.address, "scan", a_cell(), random_());
    other_scan_ = write_sphere(server_.folder, 5);
    wait_until_back();
  }

  Return round() {
    const auto import = server_.start_burnish({"import", other_scan_, "--name", "other"});
    openers_->start();
    edit_for(milliseconds(random_() % 500));
    kill();
    openers_->stop();
    Clock::time_point begin = Clock::now();
    server_.start();
    const double listening_s = seconds_since(begin);
    if (random_() % 4 == 0) {  // again, while clients come back
      edit_for(milliseconds(random_() % 60));
      kill();
      begin = Clock::now();
      server_.start();
    }
    wait_until_back();
    Return taken{listening_s, seconds_since(begin), 0, 0, 0};
    for_each_editor([](RestlessEditor& editor) { ASSERT_TRUE(editor.wait_until_answered()); });
    check_histories();
    EXPECT_THAT(openers_->broken_promises(), testing::IsEmpty());
    check_scans();
    for_each_editor([&](const RestlessEditor& editor) { taken.edits += editor.applied(); });
    taken.edits += openers_->acknowledged();
    taken.forks = openers_->forks();
    taken.races = openers_->told();
    return taken;
  }

  /// Ends the server as a supervisor does, while all clients edit, and starts the next. Returns how
  /// long the end took.
  double drain() {
    edit_for(milliseconds(random_() % 300));
    server_.process->signal(SIGTERM);
    const Clock::time_point begin = Clock::now();
    while (!server_.process->wait(milliseconds(0)) && Clock::now() < begin + kPatience)
      edit_for(milliseconds(5));
    const double taken_s = seconds_since(begin);
    EXPECT_EQ(server_.process->wait(milliseconds(0)), 0) << server_.process->output();
    for_each_editor([](RestlessEditor& editor) { editor.lose_server(); });
    server_.start();
    wait_until_back();
    for_each_editor([](RestlessEditor& editor) { ASSERT_TRUE(editor.wait_until_answered()); });
    check_histories();
    return taken_s;
  }

  /// Runs a server that dies at the count-th arrival at a point of die_at.cpp.
  void end_at(const std::string& point, int count) {
    kill();
    ::setenv("LD_PRELOAD", DIE_AT_LIBRARY, 1);
    ::setenv("BURNISH_DIE_AT", point.c_str(), 1);
    ::setenv("BURNISH_DIE_COUNT", std::to_string(count).c_str(), 1);
    server_.start();
    ::unsetenv("LD_PRELOAD");
    wait_until_back();
    server_.arm_fault();
    const auto import = server_.start_burnish({"import", other_scan_, "--name", "other"});
    const Clock::time_point end = Clock::now() + kPatience;
    while (!server_.process->wait(milliseconds(0)) && Clock::now() < end) edit_for(milliseconds(5));
    EXPECT_EQ(server_.process->wait(milliseconds(0)), 128 + SIGKILL) << point;
    for_each_editor([](RestlessEditor& editor) { editor.lose_server(); });
    check_journal();
    server_.start();
    wait_until_back();
    for_each_editor([](RestlessEditor& editor) { ASSERT_TRUE(editor.wait_until_answered()); });
    check_histories();
    check_scans();
  }

  /// Checks that one more kill does not change the fields.
  void check_fields() {
    const auto before = fields();
    kill();
    server_.start();
    EXPECT_EQ(fields(), before);
  }

 private:
  /// Lets sessions without users leave memory after a second.
  void spill_soon() {
    std::ofstream(server_.folder / "server.toml")
        << "[sessions]\nidle_spill_seconds = 1\n[limits]\nsessions_max = 10000\n";
    server_.flags = {"--config", (server_.folder / "server.toml").string()};
    server_.kill();
    server_.start();
  }

  Connection connect() { return Connection::open(server_.address, kPatience).value(); }

  /// Returns a cell of the scan's only preparation.
  Vec3i a_cell() {
    for (const auto& file : fs::recursive_directory_iterator(server_.folder / "data" / "scans"))
      if (file.path().extension() == ".prepared")
        return morton_point(read_prepared_mesh(file.path()).value()->cells.front());
    return Vec3i::Zero();
  }

  template <typename What>
  void for_each_editor(What what) {
    for (auto& [session, editors] : editors_)
      for (auto& editor : editors) what(*editor);
  }

  // Nothing waits for this time to pass: it picks the moment at which another process dies.
  void edit_for(milliseconds time) {
    const Clock::time_point end = Clock::now() + time;
    while (Clock::now() < end) {
      for_each_editor([&](RestlessEditor& editor) {
        if (random_() % 4 == 0) editor.edit();
        editor.listen();
      });
      std::this_thread::sleep_for(milliseconds(3));
    }
  }

  void kill() {
    EXPECT_FALSE(server_.process->wait(milliseconds(0))) << server_.process->output();
    server_.kill();
    for_each_editor([](RestlessEditor& editor) { editor.lose_server(); });
    check_journal();
  }

  void wait_until_back() {
    const Clock::time_point end = Clock::now() + kPatience;
    for_each_editor([&](RestlessEditor& editor) {
      while (!editor.is_back() && Clock::now() < end) {
        std::this_thread::sleep_for(milliseconds(1));
        for_each_editor([](RestlessEditor& other) { other.listen(); });
      }
      EXPECT_TRUE(editor.is_back()) << editor.user() << "\n" << server_.process->output();
    });
  }

  /// Checks a copy: opening the server's own journal would repair it.
  void check_journal() {
    const TemporaryFolder copy;
    for (const char* name : {"journal.sqlite", "journal.sqlite-wal"})
      if (fs::exists(server_.folder / "data" / name))
        fs::copy_file(server_.folder / "data" / name, copy / name);
    Database journal = Database::open(copy / "journal.sqlite").value();
    Statement check = journal.prepare("PRAGMA integrity_check").value();
    EXPECT_TRUE(check.step().value());
    EXPECT_EQ(check.text(0), "ok");
  }

  /// Opens the server's own journal while the server runs, which may lock it for a moment.
  Database opened_journal() {
    const fs::path path = server_.folder / "data" / "journal.sqlite";
    const Clock::time_point end = Clock::now() + kPatience;
    auto journal = Database::open(path);
    while (!journal.is_ok() && Clock::now() < end) {
      std::this_thread::sleep_for(milliseconds(5));
      journal = Database::open(path);
    }
    return std::move(journal).value();
  }

  /// Returns the recorded edits by author, in the order of their numbers.
  std::map<std::string, std::vector<std::string>> recorded_edits(const std::string& session) {
    Database journal = opened_journal();
    Statement edits = journal
                          .prepare(
                              "SELECT author, edits.id FROM edits JOIN sessions ON "
                              "sessions.id = session_id WHERE name = ? ORDER BY number")
                          .value();
    edits.bind(session);
    std::map<std::string, std::vector<std::string>> recorded;
    while (edits.step().value()) recorded[edits.text(0)].push_back(edits.text(1));
    return recorded;
  }

  void check_histories() {
    Connection connection = connect();
    for (auto& [session, editors] : editors_) {
      std::map<std::string, std::vector<std::pair<std::string, bool>>> found;
      const std::vector<HistoryEntry> history = connection.history(session).value();
      for (const HistoryEntry& entry : history)
        found[entry.author].emplace_back(entry.edit_id, entry.enabled);
      auto recorded = recorded_edits(session);
      uint64_t applied = 0;
      for (const auto& editor : editors) {
        const std::vector<std::string>& his = recorded[editor->user()];
        EXPECT_EQ(his.size(), editor->applied()) << editor->user();
        EXPECT_EQ(found[editor->user()], editor->expected_entries(his)) << editor->user();
        EXPECT_EQ(editor->refused(), editor->expected_refusals(his)) << editor->user();
        applied += editor->applied();
      }
      EXPECT_EQ(connection.state(session).value().session.edits, applied) << session;
    }
  }

  /// Checks that each scan is whole. The scan of an interrupted import may be there or not.
  void check_scans() {
    Connection connection = connect();
    const std::vector<ScanInfo> scans = connection.list_scans().value();
    EXPECT_EQ(scans.size(), server_.scans());
    for (const ScanInfo& scan : scans) {
      const fs::path prepared = server_.folder / "data" / "scans" / scan.id / "prepared";
      for (const auto& file : fs::directory_iterator(prepared)) {
        if (file.path().extension() != ".prepared") continue;  // a hierarchy may be half written
        const auto mesh = read_prepared_mesh(file.path());
        EXPECT_TRUE(mesh.is_ok()) << mesh.status().message();
      }
      const bool is_whole = scan.name != "other" || connection.delete_scan(scan.id).is_ok();
      EXPECT_TRUE(is_whole) << scan.name;
    }
    for (int i = 0; i < 1000 && server_.staged() > 0; ++i)  // running imports end
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_EQ(server_.staged(), 0u);
  }

  std::vector<std::vector<float>> fields() {
    Connection connection = connect();
    std::vector<std::vector<float>> fields;
    for (const std::string& session : kSessions)
      for (const CellValue value : {CellValue::kBeta, CellValue::kAlpha1, CellValue::kAlpha2})
        fields.push_back(connection.cells(session, value).value());
    return fields;
  }

  std::mt19937 random_;
  ServerProcess server_;
  std::unique_ptr<RestlessOpeners> openers_;
  std::string other_scan_;
  std::map<std::string, std::vector<std::unique_ptr<RestlessEditor>>> editors_;
};

TEST(KilledServer, LosesAndDoublesNoAcknowledgedEditAndComesBack) {
  const int rounds = number_from_environment("BURNISH_KILL_ROUNDS", 5);
  const int vertices = number_from_environment("BURNISH_KILL_VERTICES", 2000);
  std::vector<double> listening, back;
  size_t edits = 0, forks = 0, races = 0;
  std::unique_ptr<KilledServer> server;
  for (int i = 0; i < rounds && !HasFailure(); ++i) {
    if (i % kRoundsPerServer == 0) server = std::make_unique<KilledServer>(vertices, 1 + i);
    const Return taken = server->round();
    listening.push_back(taken.listening_s);
    back.push_back(taken.back_s);
    if (i < rounds - 1 && (i + 1) % kRoundsPerServer != 0) continue;
    server->check_fields();
    edits += taken.edits;
    forks += taken.forks;
    races += taken.races;
  }
  EXPECT_GT(edits, 0u);
  // In a few rounds it can happen that no race is won.
  if (rounds >= kRoundsPerServer) {
    EXPECT_GT(races, 0u);
    EXPECT_GT(forks, 0u);
  }
  const auto print = [](const char* what, std::vector<double> seconds) {
    std::sort(seconds.begin(), seconds.end());
    std::cout << what << " after " << seconds[seconds.size() / 2] << " s (median), "
              << seconds.back() << " s (longest)\n";
  };
  std::cout << back.size() << " rounds, " << vertices << " vertices, " << kEditors << " editors in "
            << kSessions.size() << " sessions, " << edits << " edits, each of them there once, "
            << forks << " forks, " << races << " sessions opened by two at once\n";
  print("listening", listening);
  print("everybody back and shown a frame", back);
}

TEST(DrainedServer, LosesNothingUnderLoadAndNoClientSeesAnError) {
  const int rounds = number_from_environment("BURNISH_KILL_ROUNDS", 3);
  std::vector<double> taken_s;
  std::unique_ptr<KilledServer> server;
  for (int i = 0; i < rounds && !HasFailure(); ++i) {
    if (i % kRoundsPerServer == 0) server = std::make_unique<KilledServer>(2000, 1 + i);
    taken_s.push_back(server->drain());
  }
  std::sort(taken_s.begin(), taken_s.end());
  std::cout << taken_s.size() << " drains under load: " << taken_s[taken_s.size() / 2]
            << " s (median), " << taken_s.back() << " s (longest)\n";
}

TEST(KilledServer, LosesNothingAtAnyStepOfWritingToDisk) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizer's library must be loaded first";
#endif
  KilledServer server(2000, 1);
  for (const char* point : {"before sync", "after sync", "before rename", "after rename"})
    for (const int count : {1, 2, 3}) server.end_at(point, count);
}

}  // namespace
}  // namespace burnish
