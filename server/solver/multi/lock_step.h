#pragma once

#include <functional>
#include <memory>
#include <semaphore>
#include <thread>
#include <vector>

namespace burnish {

/// Runs the same work for each shard, in a thread each. One thread runs at a time, in the order of
/// shards: a shard's own loops use all cores, and every order is the same in every run.
class LockStep {
 public:
  explicit LockStep(int shards);
  ~LockStep();
  LockStep(const LockStep&) = delete;
  LockStep& operator=(const LockStep&) = delete;

  int shards() const { return static_cast<int>(slots_.size()); }

  /// Runs work(shard) for all shards. The first one runs in the calling thread. Needs: no other
  /// call meanwhile.
  void run(const std::function<void(int)>& work);

  /// Waits until all shards have arrived here, then does `together` once before any goes on. Needs:
  /// a call from within run(). If another shard has ended its work, which only a failed machine
  /// makes it do, it goes on without `together`.
  void arrive_and_wait(const std::function<void()>& together);

  /// Returns the shard whose work this thread does; -1 outside of run().
  int current() const;

 private:
  struct Slot {
    std::binary_semaphore turn{0};
    bool has_ended = false;
    std::jthread thread;  // none for the first shard
  };

  void serve(int shard);
  void work_as(int shard);
  void hand_on(int shard);

  std::vector<std::unique_ptr<Slot>> slots_;
  const std::function<void(int)>* work_ = nullptr;
  const std::function<void()>* together_ = nullptr;
  int arrived_ = 0;  // shards that wait in arrive_and_wait()
  int threads_ = 0;
  bool is_over_ = false;
};

}  // namespace burnish
