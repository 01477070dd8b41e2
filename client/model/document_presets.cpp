// Presets, and which of them is in force.

#include "client/model/document.h"
#include "client/model/figures.h"
#include "common/edit/wavelength.h"

namespace burnish {

void Document::apply(const Preset& preset, double strength) {
  PresetFilter applied = filter_of(preset, strength, lengths());
  last_preset_ = preset;
  settings_.beta = applied.beta;
  curve_.set_curve(applied.curve);
  if (preset.brush_beta && !brush_.brush.edges) brush_.brush.beta = *preset.brush_beta;
  const bool has_bands = !applied.equaliser.bands.empty() || !equaliser().bands.empty();
  std::vector<Change> changes;
  if (has_bands) changes.push_back(SetEqualiser{std::move(applied.equaliser)});
  changes.push_back(SetTransferCurve{curve_.curve()});
  changes.push_back(SetGradientScale{beta()});
  commit_together(std::move(changes));
}

TransferCurve Document::curve_for_edges() const {
  return TransferCurve(alpha_of_wavelength(length_unit(), kEdgeWaveEdges * mean_edge()));
}

void Document::keep_edges(const EdgeFilter& preset) {
  const TransferCurve before = curve_.curve();
  if (before != curve_for_edges()) curve_before_edges_ = before;
  curve_.set_curve(curve_for_edges());
  commit_together({SetEdges{preset}, SetTransferCurve{curve_.curve()}});
}

void Document::keep_no_edges() {
  if (curve_.curve() != curve_for_edges()) return commit(SetEdges{});
  curve_.set_curve(curve_before_edges_);
  commit_together({SetEdges{}, SetTransferCurve{curve_.curve()}});
}

void Document::keep_edges_by_noise() {
  waits_for_noise_ = true;
  noise_.ask();
  take_noise();
}

// A commit would end a drag or a stroke, so the answer waits for their end.
void Document::take_noise() {
  if (noise_.is_asking() || !gesture_.empty()) return;
  const bool is_painted = std::exchange(paints_for_noise_, false);
  if (!std::exchange(waits_for_noise_, false)) {
    const auto filter = is_painted ? filter_for_paint() : std::nullopt;
    if (filter) send(SetEdges{*filter});
    return;
  }
  const auto& proposal = noise_.proposal();
  if (!proposal) return;
  if (proposal->filter.is_on()) return keep_edges(proposal->filter);
  log_.info(noise_text(*this));
}

// Strength 0 stays: only what is painted is denoised.
std::optional<EdgeFilter> Document::filter_for_paint() const {
  const auto& proposal = noise_.proposal();
  if (!proposal || !proposal->filter.is_on() || edges() != EdgeFilter{}) return std::nullopt;
  EdgeFilter filter = proposal->filter;
  filter.strength = 0;
  return filter;
}

bool Document::keeps_edges_by_noise() const {
  const auto& proposal = noise_.proposal();
  if (!proposal || !proposal->filter.is_on() || !edges().is_on()) return false;
  EdgeFilter whole = edges();
  whole.strength = proposal->filter.strength;
  return whole == proposal->filter;
}

void Document::preview_strength(const Preset& preset, double strength) {
  PresetFilter passed = filter_of(preset, strength, lengths());
  if (preset.bands.empty()) return preview_beta(passed.beta);
  preview(SetEqualiser{std::move(passed.equaliser)});
}

void Document::commit_strength(const Preset& preset) {
  if (preset.bands.empty()) return commit_beta();
  commit(SetEqualiser{equaliser()});
}

std::optional<PresetInForce> Document::preset_in_force(const std::vector<Preset>& own) const {
  const PresetFilter now = filter();
  if (last_preset_) {
    if (const auto strength = strength_of(*last_preset_, now, lengths()))
      return PresetInForce{*last_preset_, *strength};
    const PresetFilter none = filter_of(*last_preset_, 0, lengths());
    const bool is_dragged = !gesture_.empty();
    if (is_dragged && now.beta == none.beta && now.equaliser == none.equaliser)
      return PresetInForce{*last_preset_, 0};
  }
  for (const auto* all : {&own, &presets()})
    for (const Preset& preset : *all)
      if (strength_of(preset, now, lengths()) == 1) return PresetInForce{preset, 1};
  return std::nullopt;
}

}  // namespace burnish
