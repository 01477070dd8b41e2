#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

/// A phase of long work, and its usual time.
struct PlannedPhase {
  std::string_view name;
  double seconds = 0;
  bool is_transfer = false;  ///< its speed is the link's and says nothing about other phases
};

/// Returns the phases from a file to an open session, with the times that they take on two cores.
std::vector<PlannedPhase> opening_plan(uint64_t triangles);

/// One measure for work of several phases: how much of the whole is done, and how long the rest
/// takes at the speed so far. It never goes back.
class WholeProgress {
 public:
  using Time = std::chrono::steady_clock::time_point;
  WholeProgress(std::vector<PlannedPhase> plan, Time now);

  /// Takes a report. A phase that is not in the plan counts to the present one.
  void report(std::string_view phase, double fraction, Time now);

  /// Returns the done part of the whole, 0 to 1. A phase that reports no fractions goes on with the
  /// time.
  double fraction(Time now);
  /// Returns nothing until there is a speed to go by.
  std::optional<double> seconds_left(Time now);

 private:
  double planned_before(size_t phase) const;
  double done_of_phase(Time now) const;
  double slowdown() const;
  double transfer_seconds_left(Time now) const;

  std::vector<PlannedPhase> plan_;
  double total_ = 0;
  size_t phase_ = 0;
  double reported_ = 0;  // of the phase
  Time begun_;
  Time phase_begun_;
  double computed_planned_ = 0;  // seconds of ended phases that are no transfer, by plan
  double computed_taken_ = 0;    // and as they were
  double shown_ = 0;
};

/// Returns "about 20 s left", "about 3 min left" or "a few seconds left".
std::string time_left_text(double seconds);

}  // namespace burnish
