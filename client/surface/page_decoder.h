#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <vector>

#include "client/surface/page_desk.h"

namespace burnish {

/// Keeps account of the pages that a PageDesk decodes. Used from one thread.
class PageDecoder {
 public:
  /// `on_news`: take() has something; called from any thread.
  PageDecoder(PageHead head, std::function<void()> on_news);

  /// Returns whether the page is in work, or has not been taken.
  bool has(PageId page) const { return known_.contains(page); }
  /// Returns whether more pages may be handed in: a later picture may want others.
  bool has_room() const { return known_.size() < kPagesMax; }

  /// Copies the bytes. Needs: has_room(), and the page is not in work.
  void decode(PageId page, std::span<const uint8_t> bytes);

  /// Returns the pages that are done since the last call.
  std::vector<DecodedPage> take();

 private:
  static constexpr size_t kPagesMax = 64;  // as many as a slow picture leaves time for

  std::set<PageId> known_;
  std::unique_ptr<PageDesk> desk_;
};

}  // namespace burnish
