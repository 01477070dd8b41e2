#include "server/session/previews.h"

#include <algorithm>

namespace burnish {

Previews::Changes Previews::changes_by(const Gesture& gesture) {
  const Stroke* stroke = std::get_if<Stroke>(&gesture.change);
  const bool is_metric = std::holds_alternative<SetTransferCurve>(gesture.change) ||
                         std::holds_alternative<SetPalette>(gesture.change) ||
                         (stroke && stroke->brush.curve > 0);
  const bool is_shown = std::holds_alternative<SetEqualiser>(gesture.change) ||
                        std::holds_alternative<SetColour>(gesture.change) ||
                        (stroke && (stroke->brush.band > 0 || stroke->brush.colour));
  return {.metric = is_metric, .beta = !is_metric && !is_shown, .shown = is_shown};
}

void Previews::show(uint64_t connection, Gesture gesture) {
  changes_ |= changes_by(gesture);
  const auto mine = std::ranges::find(shown_, connection, &Shown::connection);
  const bool goes_on = mine != shown_.end() && mine->gesture.edit_id == gesture.edit_id &&
                       mine->gesture.change.index() == gesture.change.index();
  if (goes_on && std::holds_alternative<Stroke>(gesture.change)) {
    mine->gesture = std::move(gesture);
    return;
  }
  if (goes_on) {
    shown_.erase(mine);  // to the end: the last moved one counts
  } else {
    drop(connection);
  }
  shown_.push_back({connection, std::move(gesture)});
}

void Previews::drop(uint64_t connection) {
  const auto mine = std::ranges::find(shown_, connection, &Shown::connection);
  if (mine == shown_.end()) return;
  changes_ |= changes_by(mine->gesture);
  copy_is_old_ = true;
  shown_.erase(mine);
}

void Previews::clear() {
  while (!shown_.empty()) drop(shown_.back().connection);
}

void Previews::drop_applied(const History& history) {
  std::vector<uint64_t> applied;
  for (const Shown& shown : shown_)
    if (history.knows(shown.gesture.author, shown.gesture.edit_id))
      applied.push_back(shown.connection);
  for (const uint64_t connection : applied) drop(connection);
}

const Fields& Previews::over(const Fields& edited, Changes& changes) {
  copy_is_old_ |= changes.any();
  changes |= std::exchange(changes_, {});
  if (shown_.empty()) {
    copy_.reset();
    return edited;
  }
  if (!copy_ || copy_is_old_) {
    copy_.emplace(edited);
    for (Shown& shown : shown_) shown.painted_dabs = 0;
  }
  copy_is_old_ = false;
  for (Shown& shown : shown_) apply(shown);
  return *copy_;
}

void Previews::apply(Shown& shown) {
  if (const auto* slider = std::get_if<SetGradientScale>(&shown.gesture.change))
    copy_->set_gradient_scale(slider->beta);
  if (const auto* curve = std::get_if<SetTransferCurve>(&shown.gesture.change))
    copy_->set_transfer_curve(curve->curve);
  if (const auto* bands = std::get_if<SetEqualiser>(&shown.gesture.change))
    copy_->set_equaliser(bands->equaliser);
  if (const auto* palette = std::get_if<SetPalette>(&shown.gesture.change))
    copy_->set_palette(palette->palette);
  if (const auto* colour = std::get_if<SetColour>(&shown.gesture.change))
    copy_->set_colour(colour->filter);
  if (const auto* stroke = std::get_if<Stroke>(&shown.gesture.change)) {
    const std::vector<Vec3d> centres = dab_centres(*stroke);
    if (centres.size() <= shown.painted_dabs) return;
    copy_->paint(stroke->brush, std::span(centres).subspan(shown.painted_dabs));
    shown.painted_dabs = centres.size();
  }
}

Previews::Changes Previews::set_aside() {
  Changes changes = std::exchange(changes_, {});
  for (const Shown& shown : shown_) changes_ |= changes_by(shown.gesture);
  copy_is_old_ = true;  // the edited fields may change before the next over()
  changes |= changes_;
  return changes;
}

}  // namespace burnish
