#include <utility>
#include <vector>

#include "client/model/tasks/async_task.h"
#include "client/model/tasks/tasks.h"
#include "client/web/core/host/stacks.h"

namespace burnish {

struct Tasks::Running {
  const std::shared_ptr<std::atomic<bool>> asked = std::make_shared<std::atomic<bool>>(false);
  bool ended = false;
  Completion completion;
};

Tasks::Tasks(std::function<void()> on_end) : on_end_(std::move(on_end)) {}

Tasks::~Tasks() {
  for (const auto& task : running_) task->asked->store(true);
}

void Tasks::start(Work work) {
  start_stack([task = running_.emplace_back(std::make_shared<Running>()), work = std::move(work),
               on_end = on_end_] {
    task->completion = work(StopToken(task->asked));
    task->ended = true;
    on_end();
  });
}

void Tasks::drain() {
  std::vector<Completion> completions;
  for (const auto& task : running_)
    if (task->ended) completions.push_back(std::move(task->completion));
  std::erase_if(running_, [](const auto& task) { return task->ended; });
  for (const Completion& completion : completions)
    if (completion) completion();
}

struct AsyncTask::Running {
  bool ended = false;
  int waiting = 0;
};

// The work is done on another stack, so what it refers to lives until then: wait() ends after it.
AsyncTask::AsyncTask(std::function<void()> work) : running_(std::make_unique<Running>()) {
  start_stack([running = running_.get(), work = std::move(work)] {
    work();
    running->ended = true;
    resume_stack(running->waiting);
  });
}

AsyncTask::AsyncTask(AsyncTask&&) noexcept = default;

AsyncTask::~AsyncTask() {
  if (running_) wait();
}

void AsyncTask::wait() {
  running_->waiting = this_stack();
  while (!running_->ended) wait_on_stack();
}

}  // namespace burnish
