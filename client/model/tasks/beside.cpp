#include "client/model/tasks/beside.h"

#include <thread>

namespace burnish {

struct Beside::Running {
  std::thread thread;
};

Beside::Beside(std::function<void()> work)
    : running_(std::make_unique<Running>(Running{std::thread(std::move(work))})) {}

Beside::Beside(Beside&&) noexcept = default;

Beside::~Beside() {
  if (running_) wait();
}

void Beside::wait() {
  if (running_->thread.joinable()) running_->thread.join();
}

}  // namespace burnish
