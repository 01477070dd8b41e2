#include "server/fields/fields.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "server/fields/cell_index.h"

namespace burnish {

// With fewer cells, one thread is done with β before others wake.
static constexpr size_t kParallelMin = 1 << 18;

Fields::Fields(const PreparedMesh& prepared)
    : prepared_(prepared),
      may_have_paint_((prepared.cells.size() + kStretch - 1) / kStretch, 0),
      beta_(prepared.cells.size(), static_cast<float>(kBetaDefault)),
      follow_(prepared.cells.size(), 1),
      own_(prepared.cells.size(), 0),
      blend_is_old_(may_have_paint_.size(), 1) {
  paint_[kBetaLayer].emplace(prepared.cells.size());
}

void Fields::set(const Settings& settings) {
  if (settings.curve != settings_.curve || settings.palette != settings_.palette) make_blends_old();
  beta_is_old_ |= settings.beta != settings_.beta;
  settings_ = settings;
}

void Fields::set_transfer_curve(const TransferCurve& curve) {
  settings_.curve = curve;
  make_blends_old();
}

void Fields::set_palette(const Palette& palette) {
  settings_.palette = palette;
  make_blends_old();
}

void Fields::set_gradient_scale(double beta) {
  settings_.beta = beta;
  beta_is_old_ = true;
}

Status Fields::override_cells(const SetCellFields& change) {
  std::vector<OwnFields> all = overrides_;
  for (const SetCellFields::Cell& cell : change.cells) {
    ASSIGN_OR_RETURN(const int32_t index, index_of_cell(prepared_, cell.cell));
    all.push_back({index, static_cast<float>(cell.alpha1), static_cast<float>(cell.alpha2),
                   static_cast<float>(cell.beta)});
  }
  std::ranges::stable_sort(all, {}, &OwnFields::cell);
  overrides_.clear();
  for (const OwnFields& own : all) {
    if (!overrides_.empty() && overrides_.back().cell == own.cell) overrides_.pop_back();
    overrides_.push_back(own);
    may_have_paint_[own.cell / kStretch] = 1;
  }
  beta_is_old_ = true;
  make_blends_old();
  return Status::ok();
}

void Fields::clear_overrides() {
  overrides_.clear();
  beta_is_old_ = true;
  make_blends_old();
}

FieldsView Fields::view() const {
  if (beta_is_old_) update_beta();
  beta_is_old_ = false;
  const bool is_blended = hold_ || has_painted_curves();
  if (is_blended && alphas_are_old_) update_blended_own();
  const std::vector<OwnFields>& own = is_blended ? blended_own_ : overrides_;
  return {{&settings_.curve, own, rims_ ? rims_->view() : LineView{}},
          beta_,
          settings_.beta,
          {follow_, own_, may_have_paint_}};
}

CellAlphas Fields::alphas() const {
  CellAlphas alphas;
  evaluate(view().metric, prepared_, alphas);
  return alphas;
}

std::vector<float> Fields::edited() const {
  const std::span<const float> beta = view().beta;
  std::vector<float> edited(beta.size());
  const size_t bands = equaliser().bands.size();
#pragma omp parallel for schedule(static)
  for (size_t c = 0; c < edited.size(); ++c) {
    float gains = 0;
    for (size_t band = 1; band <= bands; ++band) {
      const PaintLayer* paint = gain_paint(band);
      const float weight = paint ? paint->weight[c] : 0, painted = paint ? paint->value[c] : 0;
      const float gain =
          (1 - weight) * static_cast<float>(equaliser().gain(band)) + weight * painted;
      gains = std::max(gains, std::abs(gain - 1));
    }
    if (hold_) gains *= 1 - hold_->weight[c];
    edited[c] = std::min(std::max(std::abs(beta[c] - 1), gains), 1.0f);
  }
  return edited;
}

uint64_t Fields::byte_count() const {
  uint64_t bytes = 3 * beta_.size() * sizeof(float) + may_have_paint_.size() +
                   blend_is_old_.size() +
                   (overrides_.size() + blended_own_.size()) * sizeof(OwnFields) +
                   (hold_ ? hold_->byte_count() : 0) + (rims_ ? rims_->byte_count() : 0) +
                   (colour_hold_ && colour_hold_ != hold_ ? colour_hold_->byte_count() : 0);
  for (const auto& layer : paint_)
    if (layer) bytes += layer->byte_count();
  return bytes;
}

void Fields::update_beta() const {
#pragma omp parallel for schedule(static) if (beta_.size() >= kParallelMin)
  for (size_t stretch = 0; stretch < may_have_paint_.size(); ++stretch) update_beta(stretch);
  for (const OwnFields& own : overrides_) {
    beta_[own.cell] = own.beta;
    follow_[own.cell] = 0;
    own_[own.cell] = own.beta - 1;
  }
  if (hold_) hold_beta();
}

void Fields::update_beta(size_t stretch) const {
  const size_t begin = stretch * kStretch, end = std::min(begin + kStretch, beta_.size());
  if (!may_have_paint_[stretch])
    return std::fill(&beta_[begin], &beta_[begin] + (end - begin),
                     static_cast<float>(settings_.beta));
  const PaintLayer& paint = *paint_[kBetaLayer];
  for (size_t c = begin; c < end; ++c) {
    const double weight = paint.weight[c], painted = paint.value[c];
    beta_[c] = static_cast<float>((1 - weight) * settings_.beta + weight * painted);
    follow_[c] = static_cast<float>(1 - weight);
    own_[c] = static_cast<float>(weight * (painted - 1));
  }
}

// ---- Cells that are held in place ----

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
