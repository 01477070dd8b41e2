#include "client/connection/session_link.h"

#include "client/connection/connection_state.h"
#include "client/connection/live_worker.h"

namespace burnish {

SessionLink::SessionLink(const Connection& connection, LiveOptions options)
    : worker_(std::make_unique<Worker>(connection.state_->route, connection.state_->trust,
                                       connection.state_->user, connection.state_->starter,
                                       std::move(options))) {}

SessionLink::~SessionLink() = default;

Status SessionLink::apply(std::vector<Edit> edits) {
  const Status taken = worker_->conversation().apply(std::move(edits));
  if (taken.is_ok()) worker_->wake();
  return taken;
}

void SessionLink::preview(const std::string& edit_id, PreviewChange change) {
  worker_->conversation().preview(edit_id, std::move(change));
  worker_->wake();
}

void SessionLink::drop_preview(const std::string& edit_id) {
  worker_->conversation().drop_preview(edit_id);
  worker_->wake();
}

void SessionLink::move_brush(const std::optional<BrushRing>& ring) {
  worker_->conversation().move_brush(ring);
  worker_->wake();
}

Status SessionLink::show_pages(std::vector<std::shared_ptr<const Page>> added,
                               std::vector<PageId> removed) {
  const Status changed = worker_->conversation().show_pages(added, removed);
  if (changed.is_ok()) worker_->wake();
  return changed;
}

LiveNews SessionLink::take(bool draws) {
  LiveNews news = worker_->conversation().take(draws);
  worker_->wake();
  return news;
}

void SessionLink::on_picture(std::chrono::microseconds took) {
  worker_->conversation().on_picture(took);
}

bool SessionLink::wait_until_acknowledged(std::chrono::milliseconds patience) {
  return worker_->wait_until_acknowledged(patience);
}

}  // namespace burnish
