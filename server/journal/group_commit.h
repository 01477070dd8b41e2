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

/// Writes to one database on a thread of its own, in the order in which they were posted. What
/// comes while a commit waits for the disk shares the next one. Each piece of work is done whole or
/// not at all; one that fails does not touch the others of its commit. Work in the background has
/// commits of its own, behind what came with it. Thread-safe.
class GroupCommit {
 public:
  using Work = std::function<Status(Database&)>;
  using Done = std::function<void(const Status&)>;

  explicit GroupCommit(Database database);

  /// Does what has been posted, and returns when every `done` has.
  ~GroupCommit();

  /// Queues work; `done` hears from the writing thread when it is on disk, or why it is not. It
  /// must not wait for this object: that thread is the one that would serve it.
  void post(Work work, Done done);

  /// The same for what nobody waits for, and what may be large.
  void post_background(Work work, Done done);

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
    bool is_background = false;
    Status status;
  };

  void enqueue(Item item);
  void run();
  void commit(std::span<Item> items);
  Status commit_all(std::span<Item> items);

  std::mutex database_mutex_;
  Database database_;
  std::atomic<uint64_t> commits_{0};

  std::mutex mutex_;  // of what follows
  std::condition_variable wake_;
  std::vector<Item> queue_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace burnish
