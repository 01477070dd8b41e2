#include "client/model/tasks/async_task.h"

#include <thread>

namespace burnish {

struct AsyncTask::Running {
  std::thread thread;
};

AsyncTask::AsyncTask(std::function<void()> work)
    : running_(std::make_unique<Running>(Running{std::thread(std::move(work))})) {}

AsyncTask::AsyncTask(AsyncTask&&) noexcept = default;

AsyncTask::~AsyncTask() {
  if (running_) wait();
}

void AsyncTask::wait() {
  if (running_->thread.joinable()) running_->thread.join();
}

}  // namespace burnish
