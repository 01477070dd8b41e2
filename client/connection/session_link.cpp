#include "client/connection/session_link.h"

#include "client/connection/connection_state.h"
#include "client/connection/live_worker.h"
#include "common/base/limits.h"
#include "common/wire/edit_wire.h"

namespace burnish {

static Status check(const std::vector<Edit>& edits) {
  if (edits.empty() || edits.size() > kEditsPerFrameMax)
    return invalid_argument("1 to " + std::to_string(kEditsPerFrameMax) +
                            " edits go together, not " + std::to_string(edits.size()));
  for (const Edit& edit : edits) {
    RETURN_IF_ERROR(check_edit_id(edit.id));
    RETURN_IF_ERROR(validate(edit).with_context("edit " + edit.id));
    if (std::holds_alternative<SetCellFields>(edit.change))
      return invalid_argument("edit " + edit.id + ": cell fields are not for a live session");
  }
  return Status::ok();
}

SessionLink::SessionLink(const Connection& connection, LiveOptions options)
    : worker_(std::make_unique<Worker>(connection.state_->server, connection.state_->trust,
                                       connection.state_->user, connection.state_->starter,
                                       std::move(options))) {}

SessionLink::~SessionLink() = default;

Status SessionLink::apply(std::vector<Edit> edits) {
  RETURN_IF_ERROR(check(edits));
  return worker_->apply(std::move(edits));
}

void SessionLink::preview(const std::string& edit_id, PreviewChange change) {
  worker_->preview(edit_id, std::move(change));
}

void SessionLink::drop_preview(const std::string& edit_id) {
  worker_->drop_preview(edit_id);
}

void SessionLink::move_brush(const std::optional<BrushRing>& ring) {
  worker_->move_brush(ring);
}

Status SessionLink::show_pages(std::vector<std::shared_ptr<const Page>> added,
                               std::vector<PageId> removed) {
  return worker_->show_pages(added, removed);
}

LiveNews SessionLink::take() {
  return worker_->take();
}

bool SessionLink::wait_until_acknowledged(std::chrono::milliseconds patience) {
  return worker_->wait_until_acknowledged(patience);
}

Status SessionLink::Worker::apply(std::vector<Edit> edits) {
  {
    const std::lock_guard lock(mutex_);
    if (news_.link == LinkState::kEnded) return failed_precondition("the session has ended");
    outbox_.apply(std::move(edits), options_.clock());
  }
  wakeup_->wake();
  return Status::ok();
}

void SessionLink::Worker::preview(const std::string& edit_id, PreviewChange change) {
  {
    const std::lock_guard lock(mutex_);
    outbox_.preview(edit_id, std::move(change), options_.clock());
  }
  wakeup_->wake();
}

void SessionLink::Worker::drop_preview(const std::string& edit_id) {
  {
    const std::lock_guard lock(mutex_);
    outbox_.drop_preview(edit_id);
  }
  wakeup_->wake();
}

void SessionLink::Worker::move_brush(const std::optional<BrushRing>& ring) {
  {
    const std::lock_guard lock(mutex_);
    outbox_.move_brush(ring);
  }
  wakeup_->wake();
}

Status SessionLink::Worker::show_pages(const std::vector<std::shared_ptr<const Page>>& added,
                                       const std::vector<PageId>& removed) {
  {
    const std::lock_guard lock(mutex_);
    RETURN_IF_ERROR(outbox_.pages().change(added, removed));
  }
  wakeup_->wake();
  return Status::ok();
}

LiveNews SessionLink::Worker::take() {
  const auto now = options_.clock();
  LiveNews news;
  {
    const std::lock_guard lock(mutex_);
    pacer_.on_drawn(now);
    if (std::exchange(has_new_frame_, false))
      news_.stats.waited_ms =
          std::chrono::duration<double, std::milli>(now - last_decoded_).count();
    news.link = news_.link;
    news.stats = news_.stats;
    news.stats.frames_per_second = rate_.frames_per_second(now);
    news.stats.frame_bytes_max = budget_.bytes();
    news.stats.megabits_per_second = rate_.megabits_per_second(now);
    news.pages_refused = news_.pages_refused;
    news.unacknowledged = outbox_.unacknowledged();
    news.events.swap(news_.events);
    news.frame = news_.frame;
  }
  wakeup_->wake();
  return news;
}

bool SessionLink::Worker::wait_until_acknowledged(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  acknowledged_.wait_for(lock, patience, [this] {
    return outbox_.unacknowledged() == 0 || news_.link == LinkState::kEnded;
  });
  return outbox_.unacknowledged() == 0;
}

}  // namespace burnish
