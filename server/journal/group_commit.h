#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

#include "server/journal/sqlite.h"

namespace burnish {

/// Writes to one database on its own thread, in the order of posting. Work that comes while a
/// commit waits for the disk shares the next commit. Each piece of work is done whole or not at
/// all; a failed piece does not touch the others of its commit. Background work has its own
/// commits, after those of earlier work. Thread-safe.
class GroupCommit {
 public:
  using Work = std::function<Status(Database&)>;
  using Done = std::function<void(const WriteOutcome&)>;

  explicit GroupCommit(Database database);

  /// Does all posted work, and returns when every `done` has returned.
  ~GroupCommit();

  /// Queues work. The writing thread calls `done` with the outcome. `done` must not wait for this
  /// object: it runs on the only thread that serves it.
  void post(Work work, Done done);

  /// Does the same for work that nobody waits for and that may be large.
  void post_background(Work work, Done done);

  /// Does the same and waits. Fails: as the work does; unavailable (the outcome is unknown).
  Status write(const Work& work);

  /// Runs `work` in the calling thread, after everything posted before.
  Status read(const Work& work);

  /// Returns the number of commits so far.
  uint64_t commits() const { return commits_; }

 private:
  struct Item {
    Work work;
    Done done;
    bool is_background = false;
    WriteOutcome outcome;
  };

  void enqueue(Item item);
  void run();
  void commit(std::span<Item> items);
  WriteOutcome commit_all(std::span<Item> items);
  Status work_alone(Item& item);

  std::mutex database_mutex_;
  Database database_;
  std::atomic<uint64_t> commits_{0};

  std::mutex mutex_;  // guards the following members
  std::condition_variable wake_;
  std::vector<Item> queue_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace burnish
