#include "client/model/workspace/leaving.h"

namespace burnish {

static constexpr std::chrono::seconds kMoment{1};

void Leaving::begin(What what, Time now) {
  what_ = what;
  if (!has_begun_) begun_ = now;
  has_begun_ = true;
}

Leaving::Step Leaving::update(const Unsaved& unsaved, bool is_live, Time now) {
  if (!has_begun_) return Step::kStay;
  const bool is_lost = unsaved.edits > 0 || (what_ == What::kWindow && unsaved.files > 0);
  if (!is_lost || is_discarding_) return Step::kLeave;
  if (is_waiting_) return Step::kWait;
  if (!is_live || now - begun_ >= kMoment) is_asking_ = true;
  return is_asking_ ? Step::kAsk : Step::kSave;
}

}  // namespace burnish
