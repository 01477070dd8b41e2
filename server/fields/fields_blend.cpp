// The part of Fields for cells whose α are blended: by painted curves, and by what is held.

#include <cmath>

#include "server/fields/fields.h"

namespace burnish {

/// Curves of the palette that rule a part of a cell. The session's own curve has the rest.
class Fields::CurveBlend {
 public:
  CurveBlend(const Fields& fields, size_t cell) : base_(fields.curve_) {
    for (size_t i = 0; i < fields.palette_.curves.size(); ++i) {
      const auto& layer = fields.paint_[kFirstCurveLayer + i];
      if (!layer || layer->weight[cell] == 0) continue;
      parts_[count_++] = {&fields.palette_.curves[i].curve, layer->weight[cell]};
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

// Walks through the overrides and the cells together: both are by rising cell.
void Fields::update_blended_own() const {
  alphas_are_old_ = false;
  blended_own_.clear();
  const double alpha_of_grid = 1 / prepared_.alpha_scale();
  auto over = overrides_.begin();
  for (size_t c = 0; c < beta_.size(); ++c) {
    const bool is_own = over != overrides_.end() && over->cell == static_cast<int32_t>(c);
    const float held = hold_ ? hold_->weight[c] : 0;
    if (!is_own && held == 0 && !may_have_paint_[c / kStretch]) continue;
    const CurveBlend blend(*this, c);
    if (!is_own && held == 0 && !blend.is_painted()) continue;
    const CellCurvature& of = prepared_.curvature[c];
    const double alpha1 = is_own ? double{over->alpha1} : blend.alpha(of.kappa1);
    const double alpha2 = is_own ? double{over->alpha2} : blend.alpha(of.kappa2);
    blended_own_.push_back({static_cast<int32_t>(c),
                            static_cast<float>(held_alpha(alpha1, held, alpha_of_grid)),
                            static_cast<float>(held_alpha(alpha2, held, alpha_of_grid)), beta_[c]});
    if (is_own) ++over;
  }
}

}  // namespace burnish
