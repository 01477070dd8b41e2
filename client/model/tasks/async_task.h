#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace burnish {

/// Work that runs beside its caller: on a thread, or in a browser on a stack of its own.
class AsyncTask {
 public:
  explicit AsyncTask(std::function<void()> work);
  ~AsyncTask();  ///< waits too
  AsyncTask(AsyncTask&&) noexcept;
  AsyncTask& operator=(AsyncTask&&) = delete;

  /// Returns when the work has ended.
  void wait();

 private:
  struct Running;  // async_task.cpp; client/web/core/host/tasks_on_stacks.cpp
  std::unique_ptr<Running> running_;
};

/// An answer that is on its way. Must not outlive what the question refers to.
template <typename Answer>
class Future {
 public:
  template <typename Question>
  explicit Future(Question question)
      : answer_(std::make_unique<std::optional<Answer>>()),
        work_([answer = answer_.get(), question = std::move(question)] {
          answer->emplace(question());
        }) {}

  /// Waits for the answer. Call once.
  Answer take() {
    work_.wait();
    return std::move(**answer_);
  }

 private:
  std::unique_ptr<std::optional<Answer>> answer_;
  AsyncTask work_;  // last: it writes the answer
};

/// Asks several questions at once, where each takes a round trip.
template <typename Question>
auto ask(Question question) {
  return Future<decltype(question())>(std::move(question));
}

}  // namespace burnish
