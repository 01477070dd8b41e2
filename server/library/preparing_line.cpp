#include "server/library/preparing_line.h"

#include "server/scheduling/cancellable_lock.h"

namespace burnish {

Result<PreparingLine::Turn> PreparingLine::wait(const std::string& scan_id, bool is_small,
                                                const Progress& progress) {
  Turn turn;
  turn.scan_ = scans_.of(scan_id);
  ASSIGN_OR_RETURN(turn.scan_lock_,
                   lock_or_cancel(*turn.scan_, "waiting for another call for the scan", progress));
  FairMutex& place = is_small ? small_ : large_;
  ASSIGN_OR_RETURN(turn.place_lock_, lock_or_cancel(place, "waiting for another scan", progress));
  return turn;
}

}  // namespace burnish
