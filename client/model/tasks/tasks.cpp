#include "client/model/tasks/tasks.h"

#include <thread>
#include <utility>
#include <vector>

namespace burnish {

struct Tasks::Running {
  ~Running() {
    asked->store(true);
    if (thread.joinable()) thread.join();
  }

  const std::shared_ptr<std::atomic<bool>> asked = std::make_shared<std::atomic<bool>>(false);
  std::atomic<bool> ended{false};
  Completion completion;
  std::thread thread;
};

Tasks::Tasks(std::function<void()> on_end) : on_end_(std::move(on_end)) {}

Tasks::~Tasks() {
  for (const auto& task : running_) task->asked->store(true);
}

void Tasks::start(Work work) {
  Running* const task = running_.emplace_back(std::make_shared<Running>()).get();
  task->thread = std::thread([task, work = std::move(work), on_end = on_end_] {
    task->completion = work(StopToken(task->asked));
    task->ended.store(true, std::memory_order_release);
    on_end();  // after it: an owner that is told before finds nothing, and rests
  });
}

void Tasks::drain() {
  std::vector<Completion> completions;
  for (auto task = running_.begin(); task != running_.end();) {
    if (!(*task)->ended.load(std::memory_order_acquire)) {
      ++task;
      continue;
    }
    (*task)->thread.join();
    completions.push_back(std::move((*task)->completion));
    task = running_.erase(task);
  }
  for (const Completion& completion : completions)
    if (completion) completion();
}

}  // namespace burnish
