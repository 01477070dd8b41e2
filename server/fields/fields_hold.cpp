// The part of Fields that holds cells in place.

#include "server/fields/fields.h"

namespace burnish {

void Fields::set_hold(std::shared_ptr<const Hold> hold) {
  hold_ = hold && !hold->cells.empty() ? std::move(hold) : nullptr;
  mark_held();
  beta_is_old_ = true;
  make_blends_old();
}

void Fields::mark_held() {
  if (!hold_) return;
  for (size_t c = 0; c < hold_->weight.size(); ++c)
    if (hold_->weight[c] > 0) may_have_paint_[c / kStretch] = 1;
}

void Fields::hold_beta() const {
  for (size_t c = 0; c < beta_.size(); ++c) {
    const float left = 1 - hold_->weight[c];
    if (left == 1) continue;
    beta_[c] = 1 + left * (beta_[c] - 1);
    follow_[c] *= left;
    own_[c] *= left;
  }
}

}  // namespace burnish
