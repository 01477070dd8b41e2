#include "client/model/workspace/leaving.h"

namespace burnish {

static constexpr std::chrono::seconds kMoment{1};

void Leaving::begin(What what, Time now) {
  what_ = what;
  if (!has_begun_) begun_ = now;
  has_begun_ = true;
}

Leaving::Step Leaving::update(size_t unsaved_edits, bool is_live, Time now) {
  if (!has_begun_) return Step::kStay;
  if (unsaved_edits == 0 || is_discarding_) return Step::kLeave;
  if (is_waiting_) return Step::kWait;
  if (!is_live || now - begun_ >= kMoment) is_asking_ = true;
  return is_asking_ ? Step::kAsk : Step::kSave;
}

}  // namespace burnish
