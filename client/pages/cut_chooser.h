#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "client/pages/chosen_cut.h"
#include "client/pages/known_pages.h"
#include "client/pages/page_demand.h"

namespace burnish {

/// The needs and limits by which a cut is chosen.
struct CutQuestion {
  PageView view;
  FrameBounds frame;
  CutTargets targets;
  PageBudget budget;
  bool is_at_rest = false;  ///< view and frame are those of the last question
  bool at_once = false;     ///< a picture at rest becomes as fine as fits with the next cut
};

/// Returns the page if it can be shown now: decoded, on the card, with values of the shown frame.
/// Else nullptr.
using FindReady = std::function<const Page*(PageId)>;

/// Chooses the pages of each picture. Every cut is legal; it holds the root if the root is ready.
/// The budget holds for every cut, except that the root is always taken.
class CutChooser {
 public:
  /// Needs: `known` outlives this.
  explicit CutChooser(const KnownPages& known);

  /// The result stays until the next call.
  const ChosenCut& choose(const CutQuestion& question, const FindReady& find_ready);

  /// The result of the last call.
  const ChosenCut& cut() const { return cut_; }
  /// Returns whether the last cut used the page, be it shown or not.
  bool is_used(PageId page) const { return is_used_[page] != 0; }
  /// Returns whether the last cut has looked at the pages of a known block.
  bool has_visited(uint32_t block) const { return finder_.has_visited(block); }

 private:
  void tally(const PageDemand& demand);
  void use(const PageDemand& demand);
  void select(const FindReady& find_ready);
  bool has_all_coarser(const WantedPage& wanted) const;
  void take(const WantedPage& wanted, const Page& page);
  uint32_t replaced_by(const WantedPage& wanted) const;
  CutUsage usage_of(const WantedPage& wanted) const;

  const KnownPages& known_;
  DemandFinder finder_;
  UsageByCoarseness usage_;
  std::vector<int> coarseness_;  ///< by page of the demand, the largest at which it is used
  ChosenCut cut_;
  PageSet is_used_;
  /// By page: triangles of the patches that replace it, in the pages that were ever shown.
  std::vector<uint32_t> replaced_;
  PageSet was_shown_;
};

}  // namespace burnish
