#include "client/connection/live_outbox.h"

#include <algorithm>

#include "common/wire/edit_wire.h"
#include "common/wire/format_wire.h"

namespace burnish {

void LiveOutbox::apply(std::vector<Edit> edits, Time now) {
  for (const Edit& edit : edits)
    if (gesture_ && gesture_->edit_id == edit.id) gesture_.reset();
  batches_.push_back({std::move(edits), now});
}

void LiveOutbox::preview(const std::string& edit_id, PreviewChange change, Time now) {
  preview_since_ = now;
  const bool goes_on = gesture_ && gesture_->edit_id == edit_id;
  if (goes_on && std::holds_alternative<Stroke>(change) &&
      std::holds_alternative<Stroke>(gesture_->change)) {
    const auto& piece = std::get<Stroke>(change).path;
    auto& path = std::get<Stroke>(gesture_->change).path;
    path.insert(path.end(), piece.begin(), piece.end());
    gesture_->sent = false;
  } else {
    gesture_ = Gesture{edit_id, std::move(change)};
  }
  dropped_preview_.clear();
}

void LiveOutbox::drop_preview(const std::string& edit_id) {
  if (!gesture_ || gesture_->edit_id != edit_id) return;
  gesture_.reset();
  dropped_preview_ = edit_id;
}

void LiveOutbox::move_brush(const std::optional<BrushRing>& ring) {
  if (ring_ == ring) return;
  ring_ = ring;
  ring_sent_ = false;
}

void LiveOutbox::restart() {
  greeted_ = false;
  for (Batch& batch : batches_) batch.sent = false;
  if (gesture_) gesture_->sent = false, gesture_->sent_points = 0;
  dropped_preview_.clear();
  ring_sent_ = !ring_;
  previews_sent_ = 0;
}

v1::ClientMessage LiveOutbox::next_part(Gesture& gesture) {
  v1::ClientMessage message;
  v1::Preview& preview = *message.mutable_preview();
  preview.set_edit_id(gesture.edit_id);
  if (auto* stroke = std::get_if<Stroke>(&gesture.change)) {
    const auto first = stroke->path.begin() + static_cast<std::ptrdiff_t>(gesture.sent_points);
    v1::Edit part = to_wire(Edit{{}, Stroke{stroke->brush, {first, stroke->path.end()}}});
    preview.mutable_stroke()->Swap(part.mutable_stroke());
    gesture.sent_points = stroke->path.size();
  } else if (auto* curve = std::get_if<SetTransferCurve>(&gesture.change)) {
    *preview.mutable_transfer_curve() = to_wire(curve->curve);
  } else {
    preview.mutable_gradient_scale()->set_beta(std::get<SetGradientScale>(gesture.change).beta);
  }
  gesture.sent = true;
  ++previews_sent_;
  return message;
}

std::optional<v1::ClientMessage> LiveOutbox::next() {
  v1::ClientMessage message;
  if (!greeted_) {
    greeted_ = true;
    *message.mutable_greeting() = greeting_;
    return message;
  }
  const auto batch = std::ranges::find(batches_, false, &Batch::sent);
  if (batch != batches_.end()) {
    batch->sent = true;
    for (const Edit& edit : batch->edits) *message.mutable_apply()->add_edits() = to_wire(edit);
    return message;
  }
  if (!dropped_preview_.empty()) {
    message.mutable_preview()->set_edit_id(dropped_preview_);
    message.mutable_preview()->mutable_drop();
    dropped_preview_.clear();
    ++previews_sent_;
    return message;
  }
  if (gesture_ && !gesture_->sent) return next_part(*gesture_);
  if (!ring_sent_) {
    ring_sent_ = true;
    message.mutable_move_brush();
    if (ring_) {
      v1::BrushRing& ring = *message.mutable_move_brush()->mutable_ring();
      *ring.mutable_centre() = to_wire(ring_->centre);
      ring.set_radius(ring_->radius);
    }
    return message;
  }
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
  if (!gesture_ || gesture_->edit_id != edit_id) return false;
  gesture_.reset();
  return true;
}

size_t LiveOutbox::unacknowledged() const {
  size_t edits = 0;
  for (const Batch& batch : batches_) edits += batch.edits.size();
  return edits;
}

}  // namespace burnish
