#pragma once

#include <memory>
#include <string>
#include <vector>

#include "client/connection/connection.h"
#include "client/live/live_link.h"

namespace burnish {

/// A session's surface at rest, read page by page from the frames of its live session.
class RestingSurface {
 public:
  /// Joins the session and waits until its surface has settled. `head`: encoded, of the scan's
  /// pages. Fails: data_loss (the head), as the server says, cancelled.
  static Result<RestingSurface> join(Connection& connection, const SessionInfo& session,
                                     const std::vector<uint8_t>& head, const Progress& progress);

  /// Returns a frame that has these pages; one with kColourPages or kGainPages in its number
  /// stands for its colours or gains. Needs: pages that the last call did not have. Fails:
  /// failed_precondition (the surface has moved), as the server says, cancelled.
  Result<std::shared_ptr<const SurfaceFrame>> frame_of(
      const std::vector<std::shared_ptr<const Page>>& pages, const Progress& progress);

  const Welcome& welcome() const { return welcome_; }
  const FrameStats& stats() const { return stats_; }  ///< of the settled surface
  /// Returns that of the whole surface, cells. Needs: frame_of() has succeeded.
  float largest_move() const { return news_.frame->largest_move; }

 private:
  class Bell;
  RestingSurface(Connection& connection, const SessionInfo& session, LiveOptions options);
  template <typename IsDone>
  Status wait_until(const IsDone& is_done, const Progress& progress);
  Status take();
  Status check_rest() const;

  std::shared_ptr<Bell> bell_;
  std::unique_ptr<LiveLink> link_;
  std::vector<PageId> shown_;
  LiveNews news_;
  Welcome welcome_;
  FrameStats stats_;
};

}  // namespace burnish
