#include "client/pages/page_requests.h"

#include <algorithm>
#include <utility>

namespace burnish {

static constexpr uint64_t kBytesInFlightMin = 64 * 1024;
static constexpr double kRoundTrips = 2;
static constexpr size_t kItemsInFlightMax = 1024;
static constexpr double kPlanSecondsMax = 0.75;  // no plans follow each other more slowly
// A peer that is alive answers within this, whatever else it does.
static constexpr std::chrono::seconds kPatience{5};
static constexpr double kLateTimes = 4;  // what the link is expected to take
static constexpr double kLateSecondsMax = 60;

uint64_t bytes_in_flight_max(const LinkSpeed& link, double until_next_plan_seconds) {
  const double seconds = kRoundTrips * link.round_trip_seconds + until_next_plan_seconds;
  const double bytes = link.bytes_per_second * seconds;
  return std::max(kBytesInFlightMin, static_cast<uint64_t>(std::min(bytes, 1e9)));
}

// Expects the next plan after as long as this one came after the last, while plans follow each
// other.
double PageRequests::until_next_plan_seconds(Time now) {
  const std::chrono::duration<double> since = now - std::exchange(planned_at_, now);
  return since.count() > kPlanSecondsMax ? 0 : since.count();
}

void PageRequests::make_plan(std::vector<MissingItem>& missing, const LinkSpeed& link, Time now,
                             const std::function<bool(PageItem)>& is_wanted) {
  plan_ = {};
  const double until_next = until_next_plan_seconds(now);
  end_late_flights(now);
  std::erase_if(missing, [&](const MissingItem& one) {
    return is_in_flight(one.item) || !failures_.may_ask(one.item, now);
  });
  const size_t looked_at = std::min(missing.size(), kItemsInFlightMax);
  std::ranges::partial_sort(missing, missing.begin() + static_cast<ptrdiff_t>(looked_at),
                            is_more_urgent);
  const uint64_t bytes_max = bytes_in_flight_max(link, until_next);
  for (size_t i = 0; i < looked_at; ++i) {
    if (!has_room_for(missing[i].bytes, bytes_max))
      cancel_unwanted(bytes_max, missing[i].bytes, is_wanted);
    if (!has_room_for(missing[i].bytes, bytes_max)) break;
    ask(missing[i], link, now);
  }
}

bool PageRequests::has_room_for(uint32_t bytes, uint64_t bytes_max) const {
  if (in_flight_.empty()) return true;
  return bytes_in_flight_ + bytes <= bytes_max && in_flight_.size() < kItemsInFlightMax;
}

void PageRequests::cancel_unwanted(uint64_t bytes_max, uint32_t bytes,
                                   const std::function<bool(PageItem)>& is_wanted) {
  for (auto flight = in_flight_.begin(); flight != in_flight_.end();) {
    const auto next = std::next(flight);
    if (!is_wanted(flight->first)) {
      plan_.cancel.push_back(flight->first);
      land(flight);
    }
    if (has_room_for(bytes, bytes_max)) return;
    flight = next;
  }
}

void PageRequests::ask(const MissingItem& missing, const LinkSpeed& link, Time now) {
  bytes_in_flight_ += missing.bytes;
  double expected_seconds = link.round_trip_seconds;
  if (link.bytes_per_second > 0)
    expected_seconds += static_cast<double>(bytes_in_flight_) / link.bytes_per_second;
  const std::chrono::duration<double> late(
      std::min(kLateTimes * expected_seconds, kLateSecondsMax));
  const Time late_after =
      now + kPatience + std::chrono::duration_cast<std::chrono::milliseconds>(late);
  in_flight_.emplace(missing.item, Flight{late_after, missing.bytes});
  plan_.ask.push_back(missing.item);
}

void PageRequests::end_late_flights(Time now) {
  for (auto flight = in_flight_.begin(); flight != in_flight_.end();) {
    const auto next = std::next(flight);
    if (now >= flight->second.late_after) {
      failures_.on_failure(flight->first, unavailable("no answer"), now);
      plan_.cancel.push_back(flight->first);
      land(flight);
    }
    flight = next;
  }
}

void PageRequests::land(std::map<PageItem, Flight>::iterator flight) {
  bytes_in_flight_ -= flight->second.bytes;
  in_flight_.erase(flight);
}

void PageRequests::on_arrival(PageItem item) {
  if (const auto flight = in_flight_.find(item); flight != in_flight_.end()) land(flight);
}

void PageRequests::on_failure(PageItem item, const Status& why, Time now) {
  failures_.on_failure(item, why, now);
  if (const auto flight = in_flight_.find(item); flight != in_flight_.end()) land(flight);
}

std::vector<PageItem> PageRequests::in_flight() const {
  std::vector<PageItem> items;
  for (const auto& [item, flight] : in_flight_) items.push_back(item);
  return items;
}

}  // namespace burnish
