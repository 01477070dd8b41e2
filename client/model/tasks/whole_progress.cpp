#include "client/model/tasks/whole_progress.h"

#include <algorithm>
#include <cmath>

namespace burnish {

static constexpr double kPriorSeconds = 1;      // weight of the plan beside what was measured
static constexpr double kWithoutReports = 0.9;  // most of a phase that only the clock moves
static constexpr double kFirstWordSeconds = 1;

std::vector<PlannedPhase> opening_plan(uint64_t triangles) {
  // Measured with a scan of 2.25 million triangles.
  const double millions = std::max(0.05, static_cast<double>(triangles) / 1e6);
  return {{"uploading", 0.05 * millions, true},
          {"reading", 0.10 * millions},
          {"grid", 0.36 * millions},
          {"curvature", 0.63 * millions},
          {"integrals", 1.12 * millions},
          {"storing", 1.17 * millions},
          {"pages", 1.14 * millions},
          {"opening the session", 1.65 * millions}};
}

WholeProgress::WholeProgress(std::vector<PlannedPhase> plan, Time now)
    : plan_(std::move(plan)), begun_(now), phase_begun_(now) {
  for (const PlannedPhase& phase : plan_) total_ += phase.seconds;
}

static double seconds_between(WholeProgress::Time from, WholeProgress::Time to) {
  return std::chrono::duration<double>(to - from).count();
}

void WholeProgress::report(std::string_view phase, double fraction, Time now) {
  size_t next = phase_;
  while (next < plan_.size() && plan_[next].name != phase) ++next;
  if (next == plan_.size()) return;
  if (next != phase_) {
    if (!plan_[phase_].is_transfer) {
      computed_planned_ += plan_[phase_].seconds;
      computed_taken_ += seconds_between(phase_begun_, now);
    }
    phase_ = next;
    phase_begun_ = now;
    reported_ = 0;
  }
  reported_ = std::max(reported_, std::clamp(fraction, 0.0, 1.0));
}

double WholeProgress::planned_before(size_t phase) const {
  double seconds = 0;
  for (size_t i = 0; i < phase; ++i) seconds += plan_[i].seconds;
  return seconds;
}

double WholeProgress::slowdown() const {
  return (computed_taken_ + kPriorSeconds) / (computed_planned_ + kPriorSeconds);
}

double WholeProgress::done_of_phase(Time now) const {
  const PlannedPhase& phase = plan_[phase_];
  if (phase.is_transfer) return reported_;
  const double expected = std::max(1e-3, phase.seconds * slowdown());
  const double by_time = 1 - std::exp(-seconds_between(phase_begun_, now) / expected);
  return std::max(reported_, kWithoutReports * by_time);
}

double WholeProgress::fraction(Time now) {
  const double done = planned_before(phase_) + plan_[phase_].seconds * done_of_phase(now);
  shown_ = std::max(shown_, done / total_);
  return shown_;
}

double WholeProgress::transfer_seconds_left(Time now) const {
  if (reported_ <= 0) return plan_[phase_].seconds;
  return seconds_between(phase_begun_, now) * (1 - reported_) / reported_;
}

std::optional<double> WholeProgress::seconds_left(Time now) {
  if (seconds_between(begun_, now) < kFirstWordSeconds) return std::nullopt;
  const PlannedPhase& phase = plan_[phase_];
  const double after = total_ - planned_before(phase_ + 1);
  const double here = phase.is_transfer ? transfer_seconds_left(now)
                                        : phase.seconds * (1 - done_of_phase(now)) * slowdown();
  return here + after * slowdown();
}

std::string time_left_text(double seconds) {
  if (seconds < 5) return "a few seconds left";
  if (seconds < 57.5)
    return "about " + std::to_string(5 * static_cast<int>(std::lround(seconds / 5))) + " s left";
  return "about " + std::to_string(std::max(1L, std::lround(seconds / 60))) + " min left";
}

}  // namespace burnish
