// The part of Fields for cells whose α are blended: by painted curves, and by what is held.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "common/base/parallel.h"
#include "server/fields/fields.h"

namespace burnish {

namespace {

/// A curve whose log α is known if it is constant. A logarithm takes longer than all else of a
/// cell.
class LoggedCurve {
 public:
  LoggedCurve() = default;
  explicit LoggedCurve(const TransferCurve& curve)
      : curve_(&curve), log_alpha_(curve.is_constant() ? std::log(curve.alpha(0)) : 0) {}

  bool is_constant() const { return curve_->is_constant(); }
  double alpha(double kappa) const { return curve_->alpha(kappa); }
  double log_alpha(double kappa) const {
    return is_constant() ? log_alpha_ : std::log(curve_->alpha(kappa));
  }

 private:
  const TransferCurve* curve_ = nullptr;
  double log_alpha_ = 0;
};

}  // namespace

/// The session's own curve and those of the palette that are painted somewhere.
struct Fields::PaintedCurves {
  struct Painted {
    LoggedCurve curve;
    const PaintLayer* layer;
  };
  LoggedCurve base;
  std::vector<Painted> painted;

  explicit PaintedCurves(const Fields& fields) : base(fields.transfer_curve()) {
    const std::vector<PaletteCurve>& curves = fields.palette().curves;
    for (size_t i = 0; i < curves.size(); ++i)
      if (const PaintLayer* layer = fields.layer(kFirstCurveLayer + i))
        painted.push_back({LoggedCurve(curves[i].curve), layer});
  }
};

/// Curves of the palette that rule a part of a cell. The session's own curve has the rest.
class Fields::CurveBlend {
 public:
  CurveBlend(const PaintedCurves& curves, size_t cell) : base_(curves.base) {
    for (const PaintedCurves::Painted& of : curves.painted) {
      const float weight = of.layer->weight[cell];
      if (weight == 0) continue;
      parts_[count_++] = {&of.curve, weight};
      rest_ -= weight;
    }
  }
  bool is_painted() const { return count_ > 0; }

  /// Returns α of the mean of log α for both curvatures.
  std::pair<double, double> alphas(const CellCurvature& of) const {
    const double first = alpha(of.kappa1);
    return {first, is_constant() ? first : alpha(of.kappa2)};
  }

 private:
  struct Part {
    const LoggedCurve* curve;
    double weight;
  };

  bool is_constant() const {
    return base_.is_constant() &&
           std::all_of(parts_.begin(), parts_.begin() + count_,
                       [](const Part& part) { return part.curve->is_constant(); });
  }

  double alpha(double kappa) const {
    if (count_ == 0) return base_.alpha(kappa);
    if (count_ == 1 && rest_ <= 0) return parts_[0].curve->alpha(kappa);
    double log_alpha = rest_ > 0 ? rest_ * base_.log_alpha(kappa) : 0;
    for (size_t i = 0; i < count_; ++i)
      log_alpha += parts_[i].weight * parts_[i].curve->log_alpha(kappa);
    return std::exp(log_alpha);
  }

  const LoggedCurve& base_;
  std::array<Part, kPaletteCurvesMax> parts_;  // the first count_
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
  std::vector<size_t> old;
  for (size_t stretch = 0; stretch < blend_is_old_.size(); ++stretch)
    if (std::exchange(blend_is_old_[stretch], uint8_t{0}) != 0) old.push_back(stretch);
  const std::vector<std::vector<OwnFields>> fresh = blend_stretches(old);
  const auto first_from = [&](auto from, size_t stretch) {
    return std::ranges::lower_bound(from, blended_own_.end(),
                                    static_cast<int32_t>(stretch * kStretch), {}, &OwnFields::cell);
  };
  std::vector<OwnFields> blended;
  blended.reserve(blended_own_.size());
  auto kept = blended_own_.begin();
  for (size_t i = 0; i < old.size(); ++i) {
    const auto begin = first_from(kept, old[i]);
    blended.insert(blended.end(), kept, begin);
    blended.insert(blended.end(), fresh[i].begin(), fresh[i].end());
    kept = first_from(begin, old[i] + 1);
  }
  blended.insert(blended.end(), kept, blended_own_.end());
  blended_own_ = std::move(blended);
}

std::vector<std::vector<OwnFields>> Fields::blend_stretches(
    const std::vector<size_t>& stretches) const {
  constexpr size_t kStretchesAlone = 64;  // for fewer, waking threads takes longer
  const PaintedCurves curves(*this);
  std::vector<std::vector<OwnFields>> blended(stretches.size());
  ParallelFailure failure;
#pragma omp parallel for schedule(dynamic) if (stretches.size() > kStretchesAlone)
  for (size_t i = 0; i < stretches.size(); ++i)
    failure.run([&] { blend_stretch(curves, stretches[i], blended[i]); });
  failure.rethrow();
  return blended;
}

// Walks through the overrides and the cells together: both are by rising cell.
void Fields::blend_stretch(const PaintedCurves& curves, size_t stretch,
                           std::vector<OwnFields>& blended) const {
  const double alpha_of_grid = 1 / prepared_.alpha_scale();
  const size_t begin = stretch * kStretch, end = std::min(begin + kStretch, beta_.size());
  auto over =
      std::ranges::lower_bound(overrides_, static_cast<int32_t>(begin), {}, &OwnFields::cell);
  if (!hold_ && !may_have_paint_[stretch]) return;
  for (size_t c = begin; c < end; ++c) {
    const bool is_own = over != overrides_.end() && over->cell == static_cast<int32_t>(c);
    const float held = hold_ ? hold_->weight[c] : 0;
    const CurveBlend blend(curves, c);
    if (!is_own && held == 0 && !blend.is_painted()) continue;
    const auto [alpha1, alpha2] = is_own ? std::pair<double, double>(over->alpha1, over->alpha2)
                                         : blend.alphas(prepared_.curvature[c]);
    blended.push_back({static_cast<int32_t>(c),
                       static_cast<float>(held_alpha(alpha1, held, alpha_of_grid)),
                       static_cast<float>(held_alpha(alpha2, held, alpha_of_grid)), beta_[c]});
    if (is_own) ++over;
  }
}

}  // namespace burnish
