#include "client/pages/page_slots.h"

#include <algorithm>
#include <functional>

#include "common/base/check.h"

namespace burnish {

std::optional<PageSlot> PageSlots::take() {
  if (!free_.empty()) {
    std::ranges::pop_heap(free_, std::greater());
    const PageSlot slot = free_.back();
    free_.pop_back();
    return slot;
  }
  if (begun_ == count_) return std::nullopt;
  return static_cast<PageSlot>(begun_++);
}

void PageSlots::give_back(PageSlot slot) {
  BURNISH_CHECK(slot < begun_, "a slot that was never taken");
  free_.push_back(slot);
  std::ranges::push_heap(free_, std::greater());
}

}  // namespace burnish
