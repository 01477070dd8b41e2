#include "client/model/pointer_queue.h"

namespace burnish {

void PointerQueue::move(const Eigen::Vector2d& place) {
  last_ = place;
  if (!steps_.empty() && steps_.back().button < 0) steps_.pop_back();
  steps_.push_back({place});
}

void PointerQueue::press(int button, bool down) {
  steps_.push_back({last_, button, down});
}

const PointerQueue::State& PointerQueue::next() {
  if (steps_.empty()) return shown_;
  const Step& step = steps_.front();
  shown_.place = step.place;
  if (step.button >= 0) shown_.down[static_cast<size_t>(step.button)] = step.down;
  steps_.pop_front();
  return shown_;
}

}  // namespace burnish
