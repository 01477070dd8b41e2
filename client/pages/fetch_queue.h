#pragma once

#include <cstdint>
#include <deque>
#include <set>
#include <vector>

#include "client/pages/page_item.h"

namespace burnish {

/// Limit of what a call of FetchPages asks for, bytes. The rest waits, so that it can be cancelled.
inline constexpr uint64_t kFetchBytesMax = 256 * 1024;

/// The items that are still to be brought: which wait, and which a call is bringing.
class FetchQueue {
 public:
  void ask(PageItem item);
  /// Nobody waits for the item any more. A call may bring it all the same.
  void cancel(PageItem item) { open_.erase(item); }

  /// Takes the items of the next call, in the order asked: at most kPagePartsPerFetchMax, and about
  /// kFetchBytesMax by the mean of those that came. Items of sheets come once no others wait, in
  /// calls of their own, of one version each.
  std::vector<PageItem> take_batch();

  /// A call has brought an item. Returns whether somebody waits for it.
  bool arrive(PageItem item, uint64_t bytes);
  bool is_open(PageItem item) const { return open_.contains(item); }

  /// A call has ended. Returns its items that somebody waits for still. They are asked for no more.
  std::vector<PageItem> end(const std::vector<PageItem>& batch);
  /// Returns the items that no call is bringing. They are asked for no more.
  std::vector<PageItem> give_up_waiting();

 private:
  void fill(std::vector<PageItem>& batch, std::deque<PageItem>& from, uint64_t parts_max);

  std::deque<PageItem> waiting_;         // and some that were cancelled
  std::deque<PageItem> waiting_sheets_;  // likewise
  std::set<PageItem> open_;              // somebody waits for them
  std::set<PageItem> under_way_;
  uint64_t parts_ = 0;  // that arrived
  uint64_t bytes_ = 0;
};

}  // namespace burnish
