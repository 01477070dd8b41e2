#include "server/library/preparing_line.h"

#include "server/scheduling/cancellable_lock.h"

namespace burnish {

static constexpr std::string_view kWaiting = "waiting for another scan";

Result<PreparingLine::Turn> PreparingLine::wait(const Wish& wish, const Progress& progress) {
  Turn turn(*this);
  turn.user_ = users_.of({wish.user, wish.is_small});
  ASSIGN_OR_RETURN(turn.user_lock_, lock_or_cancel(*turn.user_, kWaiting, progress));
  turn.scan_ = scans_.of(wish.scan_id);
  ASSIGN_OR_RETURN(turn.scan_lock_,
                   lock_or_cancel(*turn.scan_, "waiting for another call for the scan", progress));
  ASSIGN_OR_RETURN(turn.slot_lock_,
                   lock_or_cancel(wish.is_small ? small_ : large_, kWaiting, progress));
  if (wish.is_small) turn.end_ = clock_() + kSmallMax;
  return turn;
}

// Needles and folds take far more than reading tells. The user's slot among the large scans is not
// taken: who holds it may wait for this scan. That among the small is free for the next.
Status PreparingLine::Turn::change_slots(const Progress& told) {
  end_.reset();
  slot_lock_.unlock();
  user_lock_.unlock();
  ASSIGN_OR_RETURN(slot_lock_, lock_or_cancel(line_->large_, kWaiting, told));
  return Status::ok();
}

Progress PreparingLine::Turn::progress(const Progress& told) {
  return [this, told](std::string_view phase, double fraction) {
    if (end_ && line_->clock_() >= *end_ && !change_slots(told).is_ok()) return false;
    return report(told, phase, fraction);
  };
}

}  // namespace burnish
