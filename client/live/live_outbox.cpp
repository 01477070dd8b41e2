#include "client/live/live_outbox.h"

#include <algorithm>
#include <utility>

namespace burnish {

void LiveOutbox::apply(std::vector<Edit> edits, Time now) {
  for (const Edit& edit : edits) {
    if (gesture_ && gesture_->whole.edit_id == edit.id) gesture_.reset();
    if (begun_preview_ == edit.id) begun_preview_.clear();
  }
  batches_.push_back({std::move(edits), now});
}

void LiveOutbox::preview(const std::string& edit_id, PreviewChange change, Time now) {
  preview_since_ = now;
  const bool goes_on = gesture_ && gesture_->whole.edit_id == edit_id;
  if (goes_on && std::holds_alternative<Stroke>(change) &&
      std::holds_alternative<Stroke>(gesture_->whole.change)) {
    const auto& piece = std::get<Stroke>(change).path;
    auto& path = std::get<Stroke>(gesture_->whole.change).path;
    path.insert(path.end(), piece.begin(), piece.end());
    gesture_->sent = false;
  } else {
    gesture_ = Gesture{{edit_id, std::move(change)}};
  }
}

void LiveOutbox::drop_preview(const std::string& edit_id) {
  if (gesture_ && gesture_->whole.edit_id == edit_id) gesture_.reset();
}

void LiveOutbox::move_brush(const std::optional<BrushRing>& ring) {
  if (ring_ == ring) return;
  ring_ = ring;
  ring_sent_ = false;
}

void LiveOutbox::restart() {
  greeted_ = false;
  pages_.restart();
  for (Batch& batch : batches_) batch.sent = false;
  if (gesture_) gesture_->sent = false, gesture_->sent_points = 0;
  begun_preview_.clear();
  ring_sent_ = !ring_;
  previews_sent_ = 0;
}

Preview LiveOutbox::next_part(Gesture& gesture) {
  gesture.sent = true;
  ++previews_sent_;
  begun_preview_ = gesture.whole.edit_id;
  const auto* stroke = std::get_if<Stroke>(&gesture.whole.change);
  if (!stroke) return gesture.whole;
  const auto first = stroke->path.begin() + static_cast<std::ptrdiff_t>(gesture.sent_points);
  gesture.sent_points = stroke->path.size();
  return {gesture.whole.edit_id, Stroke{stroke->brush, {first, stroke->path.end()}}};
}

std::optional<ClientMessage> LiveOutbox::next() {
  if (!std::exchange(greeted_, true)) return greeting_;
  if (auto change = pages_.next()) return *change;
  const auto batch = std::ranges::find(batches_, false, &Batch::sent);
  if (batch != batches_.end()) {
    batch->sent = true;
    return ApplyEdits{batch->edits};
  }
  if (must_drop()) {
    ++previews_sent_;
    return DropPreview{std::exchange(begun_preview_, {})};
  }
  if (gesture_ && !gesture_->sent) return next_part(*gesture_);
  if (!std::exchange(ring_sent_, true)) return MoveBrush{ring_};
  return std::nullopt;
}

std::optional<LiveOutbox::Batch> LiveOutbox::answered(const std::string& edit_id) {
  const auto has_it = [&](const Batch& batch) {
    return std::ranges::find(batch.edits, edit_id, &Edit::id) != batch.edits.end();
  };
  const auto found = std::ranges::find_if(batches_, has_it);
  if (found == batches_.end()) return std::nullopt;
  Batch batch = std::move(*found);
  batches_.erase(found);
  return batch;
}

bool LiveOutbox::forget_preview(const std::string& edit_id) {
  if (!gesture_ || gesture_->whole.edit_id != edit_id) return false;
  gesture_.reset();
  begun_preview_.clear();
  return true;
}

size_t LiveOutbox::unacknowledged() const {
  size_t edits = 0;
  for (const Batch& batch : batches_) edits += batch.edits.size();
  return edits;
}

}  // namespace burnish
