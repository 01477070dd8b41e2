#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "common/page_frames/shown_pages.h"
#include "common/pages/page.h"
#include "common/service/live.h"

namespace burnish {

/// The pages that a client wants frames to carry, and what of it the server has yet to hear.
/// Changes that wait are merged into one.
class PagesToShow {
 public:
  explicit PagesToShow(uint32_t page_count) : page_count_(page_count) {}

  /// Fails: as ShownPages::check(); then nothing has changed. Needs: no null page.
  Status change(const std::vector<std::shared_ptr<const Page>>& added,
                const std::vector<PageId>& removed);

  /// Begins a new stream: the server shows no page.
  void restart();
  /// Returns the change that the server has to hear next. Returns nothing while
  /// kPageChangesInFlightMax changes wait for a frame that shows them.
  std::optional<ShowPages> next();
  /// Notes that a frame shows this revision.
  void shown(uint32_t revision) { shown_revision_ = revision; }

  /// Needs: pages that are wanted.
  std::vector<std::shared_ptr<const Page>> find(std::span<const PageId> pages) const;

 private:
  const uint32_t page_count_;
  ShownPages wanted_;  // for its checks
  std::map<PageId, std::shared_ptr<const Page>> pages_;
  bool is_changed_ = false;  // since the last change was said
  std::vector<PageId> said_;
  uint32_t revision_ = 0;  // said last
  uint32_t shown_revision_ = 0;
};

}  // namespace burnish
