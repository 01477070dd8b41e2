#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "server/journal/postgres_appends.h"

namespace burnish {

/// How long a journal in PostgreSQL waits.
struct PostgresPatience {
  PgPatience connection;
  /// For a database that is away: appends wait so long, and then their outcome is unknown.
  std::chrono::milliseconds away{60'000};
};

/// Works on one connection, on its own thread, in the order of posting. Appends that come while a
/// commit is under way share the next one. After a broken connection it connects again, and finds
/// out which appends are on disk. Thread-safe.
class PostgresQueue {
 public:
  /// Runs on the queue's thread.
  using Work = std::function<Status(PgConnection&, Holdings&)>;

  /// Fails: unavailable; as make_postgres_schema() says.
  static Result<std::unique_ptr<PostgresQueue>> open(const PgAddress& address,
                                                     const PostgresPatience& patience);

  /// Does all posted work, and returns when every `done` has returned. Waits no longer than the
  /// connection's patience for a database that is away.
  ~PostgresQueue();

  void append(PendingAppend append);

  enum class Repeat { kNever, kOnce };  ///< after a broken connection

  /// Does the work after everything posted before, and waits. Fails: as the work says; unavailable.
  Status run(const Work& work, Repeat repeat);

  /// Does the same without waiting, and logs a failure. The work is done even while the database is
  /// away, on a closed connection.
  void start(const Work& work);

  uint64_t commits() const { return commits_; }

 private:
  /// An append, or other work.
  struct Item {
    std::optional<PendingAppend> append;
    Work work;
    Repeat repeat = Repeat::kNever;
    bool is_due_anyway = false;
    std::function<void(const Status&)> done;
  };

  PostgresQueue(const PgAddress& address, const PostgresPatience& patience,
                PgConnection connection);

  void post(Item item);
  void loop();
  std::vector<PendingAppend> take_appends();
  void write(std::vector<PendingAppend> appends);
  bool wait_for_another_try(std::chrono::steady_clock::time_point end);
  Status do_work(const Item& item);
  Status connect();

  const PgAddress address_;
  const PostgresPatience patience_;
  PgConnection connection_;
  Holdings holdings_;
  Status last_problem_;
  std::atomic<uint64_t> commits_{0};

  std::mutex mutex_;  // guards the following members
  std::condition_variable wake_;
  std::deque<Item> queue_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace burnish
