#include "client/model/input/input_queue.h"

#include <algorithm>

namespace burnish {

using Kind = InputEvent::Kind;

static bool is_move(const InputEvent& event) {
  return event.kind == Kind::kMove || event.kind == Kind::kLeave;
}

static bool is_typed(const InputEvent& event) {
  return event.kind == Kind::kKey || event.kind == Kind::kCharacter;
}

void InputQueue::add(InputEvent event) {
  if (is_move(event)) last_ = event.place;
  event.place = last_;
  events_.push_back(event);
}

bool InputQueue::belongs_to(const std::vector<InputEvent>& step, const InputEvent& event) {
  if (step.empty()) return true;
  const InputEvent& last = step.back();
  if (is_move(event)) return is_move(last);
  if (event.kind == Kind::kWheel) return last.kind == Kind::kWheel;
  if (!is_typed(event) || !is_typed(last)) return false;
  return event.kind == Kind::kCharacter ||
         std::none_of(step.begin(), step.end(), [&](const InputEvent& other) {
           return other.kind == Kind::kKey && other.code == event.code;
         });
}

std::vector<InputEvent> InputQueue::next() {
  std::vector<InputEvent> step;
  if (pictures_until_typing_ > 0) {
    --pictures_until_typing_;
    if (!events_.empty() && is_typed(events_.front())) return step;
  }
  while (!events_.empty() && belongs_to(step, events_.front())) {
    const InputEvent& event = events_.front();
    pointer_.place = event.place;
    if (event.kind == Kind::kButton) {
      pointer_.down[static_cast<size_t>(event.code)] = event.down;
      pictures_until_typing_ = kPicturesUntilTyping;
    }
    step.push_back(event);
    events_.pop_front();
  }
  return step;
}

}  // namespace burnish
