// Measures how long an edit waits for the disk: SQLite in a file beside PostgreSQL on this machine,
// both with all their syncs, in turns.
//
//   journal_bench [SECONDS [FILE]]
//
// One editor, then 64 editors with a session each, that all send an edit when the last one is
// acknowledged; 3 s each, or SECONDS. A third journal is PostgreSQL with a synchronous standby.
// Writes its figures to FILE. The time is that of Journal::append(): without gRPC and the solver.

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <thread>

#include <nlohmann/json.hpp>

#include "server/journal/postgres_journal.h"
#include "server/journal/sqlite_journal.h"
#include "server/postgres/pg_connection.h"
#include "tests/bench/timing.h"
#include "tests/common/temporary_folder.h"
#include "tests/server/postgres/postgres_cluster.h"

namespace burnish {
namespace {

using std::chrono::steady_clock;

struct JournalFigures {
  double p50_ms, p95_ms, edits_per_s;
};

/// Sends edits of one session until the time is over. Returns how long each waited, in ms.
std::vector<double> edit(Journal& journal, const std::string& session,
                         steady_clock::time_point end) {
  std::vector<double> times;
  for (uint64_t number = 1; steady_clock::now() < end; ++number) {
    const AuthoredEdit edit{"ann", 0, {std::to_string(number), SetGradientScale{0.5}}};
    times.push_back(milliseconds([&] {
      const WriteOutcome outcome = journal.append(session, number, {edit});
      BURNISH_CHECK(outcome.is_on_disk(), outcome.why().message());
    }));
  }
  return times;
}

JournalFigures measure(Journal& journal, int editors, double seconds, int round) {
  std::vector<std::string> sessions;
  for (int i = 0; i < editors; ++i) {
    const std::string id = std::to_string(round) + "-" + std::to_string(i);
    const Status made = journal.create_session({id, id, "scan", {7, 0}, 0, {}}, {});
    BURNISH_CHECK(made.is_ok(), made.message());
    sessions.push_back(id);
  }
  std::mutex mutex;
  std::vector<double> times;
  {
    const auto end = steady_clock::now() + std::chrono::duration_cast<steady_clock::duration>(
                                               std::chrono::duration<double>(seconds));
    std::vector<std::jthread> threads;
    for (const std::string& session : sessions)
      threads.emplace_back([&, end] {
        const std::vector<double> mine = edit(journal, session, end);
        const std::lock_guard lock(mutex);
        times.insert(times.end(), mine.begin(), mine.end());
      });
  }
  std::ranges::sort(times);
  return {times[times.size() / 2], times[times.size() * 95 / 100],
          static_cast<double>(times.size()) / seconds};
}

struct NamedJournal {
  const char* name;
  std::unique_ptr<Journal> journal;
};

std::unique_ptr<Journal> open_postgres(PostgresCluster& cluster,
                                       const std::filesystem::path& paint) {
  const PgAddress address = PgAddress::parse(cluster.make_database()).value();
  return PostgresJournal::open(address, paint).value();
}

void wait_for_standby(PostgresCluster& primary) {
  PgConnection database =
      PgConnection::open(PgAddress::parse(primary.uri("postgres")).value(), {}, "bench").value();
  for (const char* sql :
       {"ALTER SYSTEM SET synchronous_standby_names = '*'", "SELECT pg_reload_conf()"})
    BURNISH_CHECK(database.run({sql, {}}).is_ok(), sql);
  static constexpr char kSynchronous[] =
      "SELECT count(*) FROM pg_stat_replication WHERE sync_state = 'sync' AND state = 'streaming'";
  while (database.run({kSynchronous, {}})->integer(0, 0) == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

int main_of(int argc, char** argv) {
  const double seconds = argc > 1 ? std::stod(argv[1]) : 3;
  const TemporaryFolder folder;
  PostgresCluster alone, primary;
  const PostgresCluster standby(primary);
  std::vector<NamedJournal> journals;
  journals.push_back({"SQLite", SqliteJournal::open(folder / "journal.sqlite").value()});
  journals.push_back({"PostgreSQL", open_postgres(alone, folder / "a.sqlite")});
  journals.push_back({"PostgreSQL with a standby", open_postgres(primary, folder / "b.sqlite")});
  wait_for_standby(primary);

  std::printf("%-26s %8s %9s %9s %9s\n", "journal", "editors", "p50, ms", "p95, ms", "edits/s");
  auto rows = nlohmann::ordered_json::array();
  for (int round = 0; round < 2; ++round)
    for (const int editors : {1, 64})
      for (const NamedJournal& one : journals) {
        const JournalFigures figures =
            measure(*one.journal, editors, seconds, 100 * round + editors);
        std::printf("%-26s %8d %9.3f %9.3f %9.0f\n", one.name, editors, figures.p50_ms,
                    figures.p95_ms, figures.edits_per_s);
        std::fflush(stdout);
        rows.push_back({{"journal", one.name},
                        {"editors", editors},
                        {"p50_ms", figures.p50_ms},
                        {"p95_ms", figures.p95_ms},
                        {"edits_per_s", figures.edits_per_s}});
      }
  if (argc > 2) std::ofstream(argv[2]) << rows.dump(1) << "\n";
  return 0;
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::main_of(argc, argv);
}
