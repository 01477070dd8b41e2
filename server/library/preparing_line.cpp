#include "server/library/preparing_line.h"

#include "server/scheduling/cancellable_lock.h"

namespace burnish {

static constexpr std::string_view kWaiting = "waiting for another scan";

Result<PreparingLine::Turn> PreparingLine::wait(const std::string& scan_id, bool is_small,
                                                const Progress& progress) {
  Turn turn(*this);
  turn.scan_ = scans_.of(scan_id);
  ASSIGN_OR_RETURN(turn.scan_lock_,
                   lock_or_cancel(*turn.scan_, "waiting for another call for the scan", progress));
  ASSIGN_OR_RETURN(turn.place_lock_,
                   lock_or_cancel(is_small ? small_ : large_, kWaiting, progress));
  if (is_small) turn.end_ = clock_() + kSmallMax;
  return turn;
}

// Needles and folds take far more than reading tells.
Status PreparingLine::Turn::change_places(const Progress& told) {
  end_.reset();
  place_lock_.unlock();
  ASSIGN_OR_RETURN(place_lock_, lock_or_cancel(line_->large_, kWaiting, told));
  return Status::ok();
}

Progress PreparingLine::Turn::progress(const Progress& told) {
  return [this, told](std::string_view phase, double fraction) {
    if (end_ && line_->clock_() >= *end_ && !change_places(told).is_ok()) return false;
    return report(told, phase, fraction);
  };
}

}  // namespace burnish
