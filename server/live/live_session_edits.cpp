// The part of a live session for the edits and gestures of its clients.

#include <algorithm>
#include <atomic>

#include "server/live/live_session.h"

namespace burnish {

namespace {

/// An answer needs two facts, in either order and from different threads: the outcome of the edits,
/// and whether they are on disk.
struct PendingAnswer {
  std::atomic<int> missing{2};
  ApplyOutcome outcome;
  Status on_disk;
};

std::vector<std::string> ids_of(const std::vector<Edit>& edits) {
  std::vector<std::string> ids;
  for (const Edit& edit : edits) ids.push_back(edit.id);
  return ids;
}

}  // namespace

void LiveSession::edit(uint64_t connection, std::vector<Edit> edits, size_t bytes) {
  {
    const std::lock_guard lock(mutex_);
    const auto slot = slots_.find(connection);
    if (slot == slots_.end()) return;
    if (!slot->second.subscriber->expect_answer(bytes)) return;
    edits_.push_back({slot->second.subscriber, std::move(edits), bytes});
  }
  wake();
}

/// Takes the edits of one frame: at least one message, at most kEditsPerFrameMax edits.
std::vector<LiveSession::EditMessage> LiveSession::take_edits() {
  const std::lock_guard lock(mutex_);
  std::vector<EditMessage> taken;
  size_t edits = 0;
  while (!edits_.empty()) {
    edits += edits_.front().edits.size();
    if (!taken.empty() && edits > kEditsPerFrameMax) break;
    taken.push_back(std::move(edits_.front()));
    edits_.pop_front();
  }
  return taken;
}

void LiveSession::refuse_waiting(const Status& why) {
  std::deque<EditMessage> waiting;
  {
    const std::lock_guard lock(mutex_);
    waiting.swap(edits_);
  }
  for (const EditMessage& message : waiting)
    message.from->refuse({ids_of(message.edits), why}, message.bytes);
}

void LiveSession::apply(SessionTurn& at, EditMessage message) {
  const auto& from = message.from;
  const std::vector<std::string> ids = ids_of(message.edits);
  const auto pending = std::make_shared<PendingAnswer>();
  const auto finish = [pending, from, ids, bytes = message.bytes] {
    if (--pending->missing > 0) return;
    if (pending->on_disk.is_ok()) {
      from->acknowledge({ids, pending->outcome}, bytes);
    } else {
      from->refuse({ids, pending->on_disk}, bytes);
    }
  };
  const auto outcome =
      at.submit(from->caller, message.edits, [pending, finish](const Status& on_disk) {
        pending->on_disk = on_disk;
        finish();
      });
  drop_gesture(from->connection, ids);
  if (!outcome.is_ok()) return from->refuse({ids, outcome.status()}, message.bytes);
  pending->outcome = outcome.value();
  finish();
}

// A refused one is counted too.
Status LiveSession::preview(uint64_t connection, Preview piece) {
  Status taken = take_preview(connection, std::move(piece));
  wake();
  return taken;
}

Status LiveSession::take_preview(uint64_t connection, Preview piece) {
  const std::lock_guard lock(mutex_);
  const auto slot = slots_.find(connection);
  if (slot == slots_.end()) return Status::ok();
  ++slot->second.previews;
  const Caller& caller = slot->second.subscriber->caller;
  RETURN_IF_ERROR(require_role(roles_, caller, SessionRole::kEditor, "editing"));
  const auto mine = gestures_.find(connection);
  const bool goes_on = mine != gestures_.end() && mine->second.edit_id == piece.edit_id &&
                       mine->second.change.index() == piece.change.index();
  if (auto* stroke = std::get_if<Stroke>(&piece.change); stroke && goes_on) {
    const Stroke& begun = std::get<Stroke>(mine->second.change);
    if (begun.brush != stroke->brush)
      return invalid_argument("the brush of a preview differs from the brush at its beginning");
    stroke->path.insert(stroke->path.begin(), begun.path.begin(), begun.path.end());
  }
  const auto check = [](const auto& change) { return validate(Edit{{}, change}); };
  RETURN_IF_ERROR(std::visit(check, piece.change).with_context("preview"));
  gestures_[connection] = {caller.user, std::move(piece.edit_id), std::move(piece.change)};
  changed_gestures_.insert(connection);
  return Status::ok();
}

void LiveSession::drop_preview(uint64_t connection, const std::string& edit_id) {
  {
    const std::lock_guard lock(mutex_);
    const auto slot = slots_.find(connection);
    if (slot != slots_.end()) ++slot->second.previews;
  }
  drop_gesture(connection, {edit_id});
  wake();
}

void LiveSession::drop_gesture(uint64_t connection, const std::vector<std::string>& edit_ids) {
  const std::lock_guard lock(mutex_);
  const auto mine = gestures_.find(connection);
  if (mine == gestures_.end() ||
      std::ranges::find(edit_ids, mine->second.edit_id) == edit_ids.end())
    return;
  gestures_.erase(mine);
  changed_gestures_.insert(connection);
}

void LiveSession::show_gestures(SessionTurn& at) {
  Previews& previews = at.session().previews();
  const std::lock_guard lock(mutex_);
  if (std::exchange(life_, at.life()) != at.life()) {
    steady_.reset();
    still_.reset();
    layer_points_.reset();
    previews.clear();  // they belong to an earlier live session
    for (const auto& [connection, gesture] : gestures_) changed_gestures_.insert(connection);
  }
  for (const uint64_t connection : changed_gestures_) {
    const auto gesture = gestures_.find(connection);
    if (gesture == gestures_.end()) {
      previews.drop(connection);
    } else {
      previews.show(connection, gesture->second);
    }
  }
  changed_gestures_.clear();
  for (auto& [connection, slot] : slots_)
    previews_taken_ += slot.previews - std::exchange(slot.previews_taken, slot.previews);
  previews.drop_applied(at.session().edited().history());
}

}  // namespace burnish
