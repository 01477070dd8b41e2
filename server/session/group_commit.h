#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "server/session/sqlite.h"

namespace burnish {

/// Writes to one database on a thread of its own, in the order in which they were posted. What
/// comes while a commit waits for the disk shares the next one. Each piece of work is done whole or
/// not at all; one that fails does not touch the others of its commit. Thread-safe.
class GroupCommit {
 public:
  using Work = std::function<Status(Database&)>;
  using Done = std::function<void(const Status&)>;

  explicit GroupCommit(Database database);

  /// Does what has been posted, then ends.
  ~GroupCommit();

  /// Queues work; `done` hears from the writing thread when it is on disk, or why it is not. It
  /// must not wait for this object: that thread is the one that would serve it.
  void post(Work work, Done done);

  /// The same, and waits.
  Status write(const Work& work);

  /// Runs `work` in the calling thread, behind everything posted before.
  Status read(const Work& work);

  /// Commits so far.
  uint64_t commits() const { return commits_; }

 private:
  struct Item {
    Work work;
    Done done;
    Status status;
  };

  void run();
  void commit(std::deque<Item>& items);
  Status commit_all(std::deque<Item>& items);

  std::mutex database_mutex_;
  Database database_;
  std::atomic<uint64_t> commits_{0};

  std::mutex mutex_;  // of what follows
  std::condition_variable wake_;
  std::deque<Item> queue_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace burnish
