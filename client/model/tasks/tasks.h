#pragma once

#include <atomic>
#include <functional>
#include <list>
#include <memory>

namespace burnish {

/// Tells a piece of work that its end is wanted. Copies ask the same.
class StopToken {
 public:
  StopToken() = default;  ///< nobody asks
  explicit StopToken(std::shared_ptr<const std::atomic<bool>> asked) : asked_(std::move(asked)) {}
  bool stop_requested() const { return asked_ && asked_->load(std::memory_order_relaxed); }

 private:
  std::shared_ptr<const std::atomic<bool>> asked_;
};

/// Runs work that must not delay the picture. Each piece runs on a thread of its own, or in a
/// browser on a stack of its own; the owner's thread handles its result at the next drain(). Used
/// from one thread.
class Tasks {
 public:
  /// Runs on the owner's thread with the result. May be empty.
  using Completion = std::function<void()>;
  /// Ends soon after the token asks for it. Must not touch data of the owner's thread.
  using Work = std::function<Completion(StopToken)>;

  /// `on_end`: called from any thread when drain() has a result to handle. Must not block.
  explicit Tasks(std::function<void()> on_end = [] {});
  /// Asks all work to stop, waits for it, and drops the results. In a browser it does not wait.
  ~Tasks();
  Tasks(const Tasks&) = delete;
  Tasks& operator=(const Tasks&) = delete;

  void start(Work work);

  /// Runs the completions of work that has ended.
  void drain();

  bool is_idle() const { return running_.empty(); }

 private:
  std::function<void()> on_end_;
  struct Running;  // tasks.cpp; client/web/core/host/tasks_on_stacks.cpp
  std::list<std::shared_ptr<Running>> running_;
};

}  // namespace burnish
