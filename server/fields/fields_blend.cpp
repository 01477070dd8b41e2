// The part of Fields for cells whose α are blended: by painted curves, and by what is held.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "server/fields/fields.h"

namespace burnish {

/// Curves of the palette that rule a part of a cell. The session's own curve has the rest.
class Fields::CurveBlend {
 public:
  CurveBlend(const Fields& fields, size_t cell) : base_(fields.transfer_curve()) {
    for (size_t i = 0; i < fields.palette().curves.size(); ++i) {
      const auto& layer = fields.paint_[kFirstCurveLayer + i];
      if (!layer || layer->weight[cell] == 0) continue;
      parts_[count_++] = {&fields.palette().curves[i].curve, layer->weight[cell]};
      rest_ -= layer->weight[cell];
    }
  }
  bool is_painted() const { return count_ > 0; }

  /// Returns α of the mean of log α.
  double alpha(double kappa) const {
    if (count_ == 0) return base_.alpha(kappa);
    if (count_ == 1 && rest_ <= 0) return parts_[0].curve->alpha(kappa);
    double log_alpha = rest_ > 0 ? rest_ * std::log(base_.alpha(kappa)) : 0;
    for (size_t i = 0; i < count_; ++i)
      log_alpha += parts_[i].weight * std::log(parts_[i].curve->alpha(kappa));
    return std::exp(log_alpha);
  }

 private:
  struct Part {
    const TransferCurve* curve;
    double weight;
  };
  const TransferCurve& base_;
  std::array<Part, kPaletteCurvesMax> parts_ = {};
  size_t count_ = 0;
  double rest_ = 1;
};

void Fields::make_blends_old() {
  alphas_are_old_ = true;
  std::ranges::fill(blend_is_old_, uint8_t{1});
}

// A dab makes few stretches old: the others are copied.
void Fields::update_blended_own() const {
  alphas_are_old_ = false;
  std::vector<OwnFields> blended;
  blended.reserve(blended_own_.size());
  auto kept = blended_own_.begin();
  for (size_t stretch = 0; stretch < may_have_paint_.size(); ++stretch) {
    const auto end = std::find_if(kept, blended_own_.end(), [&](const OwnFields& own) {
      return own.cell >= static_cast<int32_t>((stretch + 1) * kStretch);
    });
    if (std::exchange(blend_is_old_[stretch], uint8_t{0}) == 0)
      blended.insert(blended.end(), kept, end);
    else
      blend_stretch(stretch, blended);
    kept = end;
  }
  blended_own_ = std::move(blended);
}

// Walks through the overrides and the cells together: both are by rising cell.
void Fields::blend_stretch(size_t stretch, std::vector<OwnFields>& blended) const {
  const double alpha_of_grid = 1 / prepared_.alpha_scale();
  const size_t begin = stretch * kStretch, end = std::min(begin + kStretch, beta_.size());
  auto over =
      std::ranges::lower_bound(overrides_, static_cast<int32_t>(begin), {}, &OwnFields::cell);
  if (!hold_ && !may_have_paint_[stretch]) return;
  for (size_t c = begin; c < end; ++c) {
    const bool is_own = over != overrides_.end() && over->cell == static_cast<int32_t>(c);
    const float held = hold_ ? hold_->weight[c] : 0;
    const CurveBlend blend(*this, c);
    if (!is_own && held == 0 && !blend.is_painted()) continue;
    const CellCurvature& of = prepared_.curvature[c];
    const double alpha1 = is_own ? double{over->alpha1} : blend.alpha(of.kappa1);
    const double alpha2 = is_own ? double{over->alpha2} : blend.alpha(of.kappa2);
    blended.push_back({static_cast<int32_t>(c),
                       static_cast<float>(held_alpha(alpha1, held, alpha_of_grid)),
                       static_cast<float>(held_alpha(alpha2, held, alpha_of_grid)), beta_[c]});
    if (is_own) ++over;
  }
}

}  // namespace burnish
