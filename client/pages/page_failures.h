#pragma once

#include <chrono>
#include <map>
#include <utility>
#include <vector>

#include "client/pages/page_item.h"
#include "common/base/status.h"

namespace burnish {

/// An item that is not asked for any more.
struct GivenUpItem {
  PageItem item;
  Status last_failure;
};

/// Items that failed to come or came damaged, and when they may be asked for again: after a pause
/// that doubles, kTries times in all. Then it is given up, and told once. Sheets are tried less
/// often, for a picture is whole without them.
class PageFailures {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr int kTries = 5;
  static constexpr int kSheetTries = 2;
  static constexpr std::chrono::milliseconds kFirstPause{500};

  void on_failure(PageItem item, const Status& why, Time now);
  void on_success(PageItem item) { failures_.erase(item); }

  bool may_ask(PageItem item, Time now) const;
  bool is_given_up(PageItem item) const;

  /// Returns what was given up since the last call.
  std::vector<GivenUpItem> take_news() { return std::exchange(news_, {}); }
  /// Forgets all, as after another connection was made.
  void clear();

  size_t count() const { return failures_.size(); }

 private:
  struct Failure {
    int tries = 0;
    Time not_before;
  };

  std::map<PageItem, Failure> failures_;  // as many as the scan has items, at most
  std::vector<GivenUpItem> news_;
};

}  // namespace burnish
