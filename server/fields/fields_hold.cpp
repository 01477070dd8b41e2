// The part of Fields that holds cells in place.

#include "server/fields/fields.h"

namespace burnish {

void Fields::set_hold(std::shared_ptr<const Hold> hold) {
  hold_ = hold && !hold->cells.empty() ? std::move(hold) : nullptr;
  held_own_.clear();
  mark_held();
  beta_is_old_ = held_own_is_old_ = true;
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

// Walks through the overrides and the held cells together: both are by rising cell.
void Fields::update_held_own() const {
  held_own_is_old_ = false;
  held_own_.clear();
  const double alpha_of_grid = 1 / prepared_.alpha_scale();
  auto over = overrides_.begin();
  for (size_t c = 0; c < beta_.size(); ++c) {
    const bool is_own = over != overrides_.end() && over->cell == static_cast<int32_t>(c);
    const float weight = hold_->weight[c];
    if (!is_own && weight == 0) continue;
    const CellCurvature& of = prepared_.curvature[c];
    const double alpha1 = is_own ? double{over->alpha1} : curve_.alpha(of.kappa1);
    const double alpha2 = is_own ? double{over->alpha2} : curve_.alpha(of.kappa2);
    held_own_.push_back({static_cast<int32_t>(c),
                         static_cast<float>(held_alpha(alpha1, weight, alpha_of_grid)),
                         static_cast<float>(held_alpha(alpha2, weight, alpha_of_grid)), beta_[c]});
    if (is_own) ++over;
  }
}

}  // namespace burnish
