#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/page_frames/page_layout.h"

namespace burnish {

/// A page number plus this stands for the page's colours. Frames carry them as a page of their own,
/// with changes of red, green and blue in linear light in place of displacements: a change of 1 is
/// kCellsPerColour cells.
inline constexpr PageId kColourPages = PageId{1} << 31;
inline constexpr float kCellsPerColour = 16;

/// A page number plus this stands for the gains of the page's texels, less 1: in the place of red,
/// and in the same units. Green and blue are 0.
inline constexpr PageId kGainPages = kColourPages | PageId{1} << 30;

/// Returns true for pages of gains, too.
constexpr bool is_colours(PageId page) {
  return (page & kColourPages) != 0;
}
constexpr bool is_gains(PageId page) {
  return (page & kGainPages) == kGainPages;
}
/// Returns the page whose colours or gains these are, or the page itself.
constexpr PageId page_in_file(PageId page) {
  return page & ~kGainPages;
}

/// A page in a stream of frames.
struct ShownPage {
  PageId page = 0;
  std::shared_ptr<const PageLayout> layout;  ///< of the stream's kind

  uint32_t value_count() const { return layout->value_count(); }
};

/// A client's wish to show other pages (ShowPages). Pages come in any order.
struct PageChange {
  uint32_t revision = 0;
  std::vector<ShownPage> added;
  std::vector<PageId> removed;
};

/// The pages that a client shows at a revision. Both ends keep the same lists: a stream begins with
/// revision 0, which shows nothing, and each change makes the next revision.
class ShownPages {
 public:
  uint32_t revision() const { return revision_; }
  std::span<const ShownPage> pages() const { return pages_; }  ///< rising
  bool shows(PageId page) const;

  /// Checks a change that a client asks for; does not look at the layouts, so that a server can
  /// check page numbers before it looks the pages up.
  /// Fails: invalid_argument (a revision that does not follow, a page that the scan does not have,
  /// is named twice, is shown already, or is not shown), resource_exhausted (kShownPagesMax).
  Status check(const PageChange& change, uint32_t page_count) const;

  /// Makes the next revision. Needs: check() is ok, and the layouts of the added pages.
  ShownPages changed(const PageChange& change) const;

  /// Returns the same revision with other layouts, for frames of another kind.
  /// Needs: the same pages, rising.
  ShownPages with_layouts(std::vector<ShownPage> pages) const;

 private:
  uint32_t revision_ = 0;
  std::vector<ShownPage> pages_;
};

}  // namespace burnish
