#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/live/live_conversation.h"
#include "client/live/live_link.h"
#include "client/web/core/host/calls.h"
#include "client/web/core/host/clockwork.h"

namespace burnish {

/// A LiveLink over the worker's calls, without threads: it speaks when it is told of something, and
/// at times of its own.
class SocketLink final : public LiveLink, public Clockwork {
 public:
  SocketLink(std::shared_ptr<ServerRoute> route, LiveOptions options);

  Status apply(std::vector<Edit> edits) override;
  void preview(const std::string& edit_id, PreviewChange change) override;
  void drop_preview(const std::string& edit_id) override;
  void move_brush(const std::optional<BrushRing>& ring) override;
  Status show_pages(std::vector<std::shared_ptr<const Page>> added,
                    std::vector<PageId> removed) override;
  using LiveLink::take;
  LiveNews take(bool draws) override;
  void on_picture(std::chrono::microseconds took) override;

  Time on_time(Time now) override;

 private:
  void begin_stream();
  void listen();
  void speak();
  void leave_if_over(Time now);

  const std::shared_ptr<ServerRoute> route_;
  const Clock clock_;
  const std::function<void()> on_news_;
  LiveConversation conversation_;
  std::optional<Time> begins_at_;  // the next stream; nothing: one runs, or the session has ended
  std::unique_ptr<HostCall> stream_;
};

}  // namespace burnish
