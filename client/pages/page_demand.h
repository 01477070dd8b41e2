#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "client/pages/cut_targets.h"
#include "client/pages/known_pages.h"
#include "client/pages/page_view.h"
#include "common/pages/cut.h"

namespace burnish {

/// A page that a picture wants.
struct WantedPage {
  PageId page = 0;
  /// How many times the picture exceeds full detail without the page, or without a finer page that
  /// needs it: a coarser page has never less than a finer one.
  float excess = 0;
  bool is_seen = false;  ///< it, or a finer page that needs it, may be in the picture
  const PageEntry* entry = nullptr;
  std::span<const PageId> coarser;
};

/// An unknown block of the directory whose pages a picture may want.
struct WantedBlock {
  uint32_t block = 0;
  float excess = 0;  ///< a coarser block has never less than a finer one
  bool is_seen = false;
};

/// The wants of a picture, whatever they cost.
struct PageDemand {
  std::vector<WantedPage> pages;  ///< by number, from fine to coarse; the root is last
  std::vector<WantedBlock> blocks;
};

/// Weight of a page out of view, compared with one in view. So what lies beside the picture is
/// there coarsely when the camera turns to it.
inline constexpr float kUnseenWeight = 0.01f;

/// Finds what a picture wants: one pass over the known pages from fine to coarse. Skips blocks that
/// are too far away to matter, so that the cost follows the view, not the scan.
class DemandFinder {
 public:
  explicit DemandFinder(const KnownPages& known);

  /// `was_shown`: what the last cut showed, a byte per page. The result stays until the next call.
  const PageDemand& find(const PageView& view, const FrameBounds& frame, const CutTargets& targets,
                         const PageSet& was_shown);

  /// Returns whether the last find() looked at the pages of a known block.
  bool has_visited(uint32_t block) const { return visits_[block] == Visit::kDone; }

 private:
  enum class Visit : uint8_t { kNone, kBegun, kDone };
  struct Wish {
    float excess = 0;  ///< 0: there is no wish
    bool is_seen = false;

    void raise(const Wish& other);
  };
  struct Picture {
    const PageView& view;
    const FrameBounds& frame;
    const CutTargets& targets;
    const PageSet& was_shown;
  };

  void visit(const Picture& picture, uint32_t block);
  void visit_known(const Picture& picture, uint32_t block);
  static Wish own_wish(const Picture& picture, const PageBounds& bounds, float wanted_above,
                       bool is_needed);
  Wish page_wish(const Picture& picture, PageId page, const PageBounds& bounds) const;
  void begin_wishes(uint32_t block);
  void order_blocks();

  const KnownPages& known_;
  PageDemand demand_;
  std::vector<Wish> page_wishes_;   ///< by page, of finer pages; valid where the block's is begun
  std::vector<Wish> block_wishes_;  ///< by block, the largest of its pages'
  std::vector<Visit> visits_;       ///< by block
};

}  // namespace burnish
