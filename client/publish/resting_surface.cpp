#include "client/publish/resting_surface.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "client/connection/links.h"
#include "common/pages/directory_codec.h"

namespace burnish {

static constexpr std::chrono::milliseconds kLook{50};  // for a cancel

/// Rung by the link's thread when there is news.
class RestingSurface::Bell {
 public:
  void ring() {
    const std::lock_guard lock(mutex_);
    rung_ = true;
    changed_.notify_one();
  }
  void wait() {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, kLook, [this] { return rung_; });
    rung_ = false;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool rung_ = false;
};

// The values are those of vertices, and no picture is waited for.
RestingSurface::RestingSurface(Connection& connection, const SessionInfo& session,
                               LiveOptions options)
    : bell_(std::make_shared<Bell>()) {
  options.greeting = {session.id, PageFrameKind::kVertices};
  options.depth = session.key.depth;
  options.draw_interval = std::chrono::milliseconds(1);
  options.on_news = [bell = bell_] { bell->ring(); };
  link_ = make_live_link(connection, std::move(options));
}

Result<RestingSurface> RestingSurface::join(Connection& connection, const SessionInfo& session,
                                            const std::vector<uint8_t>& head,
                                            const Progress& progress) {
  LiveOptions options;
  ASSIGN_OR_RETURN(options.head, decode_head(head));
  options.pages_fingerprint = pages_fingerprint(head);
  RestingSurface surface(connection, session, std::move(options));
  const auto is_settled = [&] { return surface.news_.stats.frame.settled; };
  RETURN_IF_ERROR(surface.wait_until(is_settled, progress));
  surface.stats_ = surface.news_.stats.frame;
  return surface;
}

Result<std::shared_ptr<const SurfaceFrame>> RestingSurface::frame_of(
    const std::vector<std::shared_ptr<const Page>>& pages, const Progress& progress) {
  std::vector<PageId> removed = std::exchange(shown_, {});
  for (const auto& page : pages) shown_.push_back(page->id);
  RETURN_IF_ERROR(link_->show_pages(pages, std::move(removed)));
  const auto has = [this](PageId page) { return news_.frame->find(page) != nullptr; };
  const auto is_shown = [&] { return news_.frame && std::ranges::all_of(shown_, has); };
  RETURN_IF_ERROR(wait_until(is_shown, progress));
  RETURN_IF_ERROR(check_rest());
  return news_.frame;
}

Status RestingSurface::check_rest() const {
  const FrameStats& now = news_.stats.frame;
  if (now.settled && now.edits == stats_.edits && news_.frame->is_exact) return Status::ok();
  return failed_precondition("the session was edited meanwhile: try again when nobody edits it");
}

template <typename IsDone>
Status RestingSurface::wait_until(const IsDone& is_done, const Progress& progress) {
  RETURN_IF_ERROR(take());
  while (!is_done()) {
    if (!report(progress, "waiting for the surface", 0)) return cancelled("cancelled");
    bell_->wait();
    RETURN_IF_ERROR(take());
  }
  return Status::ok();
}

Status RestingSurface::take() {
  news_ = link_->take();
  for (LiveEvent& event : news_.events) {
    if (auto* welcome = std::get_if<Welcome>(&event)) welcome_ = std::move(*welcome);
    const auto* changed = std::get_if<LinkChanged>(&event);
    if (changed && changed->state == LinkState::kEnded) return unavailable(changed->reason);
  }
  return Status::ok();
}

}  // namespace burnish
