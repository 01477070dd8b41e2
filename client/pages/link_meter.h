#pragma once

#include <chrono>
#include <cstddef>
#include <deque>

#include "client/pages/page_requests.h"

namespace burnish {

/// Measures a link by the parts that calls bring over it. Calls at the same time share the link.
class LinkMeter {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// A part has come. Parts count from the first one of a call on: before it the link was idle.
  void on_part(size_t bytes, Time now);
  /// The part was the first one of a call that began at `began`.
  void on_first_part(Time began, Time now);
  /// A call has ended that had a first part.
  void on_end() { --receiving_; }

  /// Returns the sums of the last samples, and their least round trip.
  LinkSpeed speed() const;

 private:
  struct Sample {
    double bytes = 0;
    double seconds = 0;
  };

  int receiving_ = 0;  // calls between their first part and their end
  Time last_;          // part
  Sample sample_;      // that grows
  std::deque<Sample> samples_;
  std::deque<double> round_trips_;  // seconds
};

}  // namespace burnish
