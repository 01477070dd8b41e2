#include "client/model/tasks.h"

namespace burnish {

Tasks::~Tasks() {
  for (Running& task : running_) task.thread.request_stop();
}

void Tasks::start(Work work) {
  Running& task = running_.emplace_back();
  task.thread = std::jthread([&task, work = std::move(work)](const std::stop_token& stop) {
    task.completion = work(stop);
    task.ended.store(true, std::memory_order_release);
  });
}

void Tasks::drain() {
  std::vector<Completion> completions;
  for (auto task = running_.begin(); task != running_.end();) {
    if (!task->ended.load(std::memory_order_acquire)) {
      ++task;
      continue;
    }
    completions.push_back(std::move(task->completion));
    task = running_.erase(task);  // joins
  }
  for (const Completion& completion : completions)
    if (completion) completion();
}

}  // namespace burnish
