#include "server/session/previews.h"

#include <algorithm>

namespace burnish {

void Previews::show(uint64_t connection, Gesture gesture) {
  changes_ |= effects_of(gesture.change);
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
  changes_ |= effects_of(mine->gesture.change);
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

const Fields& Previews::over(const Fields& edited, EditEffects& changes) {
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
  const auto* stroke = std::get_if<Stroke>(&shown.gesture.change);
  if (!stroke) {
    Settings settings = copy_->settings();
    settings.take(shown.gesture.change);
    return set_counting(std::move(settings));
  }
  const std::vector<Vec3d> centres = dab_centres(*stroke);
  if (centres.size() <= shown.painted_dabs) return;
  copy_->paint(stroke->brush, std::span(centres).subspan(shown.painted_dabs));
  shown.painted_dabs = centres.size();
  if (stroke->brush.edges) set_counting(copy_->settings());
}

void Previews::set_counting(Settings settings) {
  copy_->set(counting_beside_edges(std::move(settings), copy_->edge_paint() != nullptr));
}

EditEffects Previews::set_aside() {
  EditEffects changes = std::exchange(changes_, {});
  for (const Shown& shown : shown_) changes_ |= effects_of(shown.gesture.change);
  copy_is_old_ = true;  // the edited fields may change before the next over()
  changes |= changes_;
  return changes;
}

}  // namespace burnish
