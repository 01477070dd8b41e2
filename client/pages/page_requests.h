#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "client/pages/page_failures.h"
#include "client/pages/page_item.h"

namespace burnish {

/// The speed of the link to the server, as far as it is known; 0 is unknown.
struct LinkSpeed {
  double bytes_per_second = 0;
  double round_trip_seconds = 0;
};

/// Returns how many bytes may be on their way at once: two round trips' worth and what comes until
/// the next plan, so that the link never waits for a request, and a little more than the first
/// picture needs.
uint64_t bytes_in_flight_max(const LinkSpeed& link, double until_next_plan_seconds = 0);

/// Decides for each picture what to ask for and what to cancel. What is asked for is in flight
/// until it comes, fails, is cancelled or is late.
class PageRequests {
 public:
  using Time = PageFailures::Time;

  struct Plan {
    std::vector<PageItem> ask;     ///< in this order
    std::vector<PageItem> cancel;  ///< no picture wants them, and others wait for their place
  };

  /// Puts `missing` into order. In flight are at most bytes_in_flight_max() bytes, or one item.
  /// `is_wanted` says whether an item in flight serves the current picture.
  void make_plan(std::vector<MissingItem>& missing, const LinkSpeed& link, Time now,
                 const std::function<bool(PageItem)>& is_wanted);
  const Plan& plan() const { return plan_; }

  /// An item has come. failures().on_success() says whether it was good.
  void on_arrival(PageItem item);
  /// An item failed, or came damaged. It is asked for again later.
  void on_failure(PageItem item, const Status& why, Time now);
  /// The link broke: nothing is in flight any more. It is no item's fault.
  void on_link_lost() { in_flight_.clear(), bytes_in_flight_ = 0; }

  bool is_in_flight(PageItem item) const { return in_flight_.contains(item); }
  std::vector<PageItem> in_flight() const;
  size_t count_in_flight() const { return in_flight_.size(); }
  uint64_t bytes_in_flight() const { return bytes_in_flight_; }
  PageFailures& failures() { return failures_; }
  const PageFailures& failures() const { return failures_; }

 private:
  struct Flight {
    Time late_after;
    uint32_t bytes;
  };

  void end_late_flights(Time now);
  void land(std::map<PageItem, Flight>::iterator flight);
  bool has_room_for(uint32_t bytes, uint64_t bytes_max) const;
  void cancel_unwanted(uint64_t bytes_max, uint32_t bytes,
                       const std::function<bool(PageItem)>& is_wanted);
  void ask(const MissingItem& missing, const LinkSpeed& link, Time now);

  double until_next_plan_seconds(Time now);

  std::map<PageItem, Flight> in_flight_;
  uint64_t bytes_in_flight_ = 0;
  PageFailures failures_;
  Plan plan_;
  Time planned_at_{};
};

}  // namespace burnish
