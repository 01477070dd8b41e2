#include "client/connection/credit_pacer.h"

#include <algorithm>
#include <cmath>

namespace burnish {

using std::chrono::milliseconds;

static constexpr auto kRttPeriod = std::chrono::seconds(10);
static constexpr double kQueuedMsMax = 12;  // more than jitter
static constexpr double kDrawMarginMs = 4;  // a frame comes so much before its picture
static constexpr double kLatencyWeight = 0.2;
static constexpr milliseconds kHoldMin{1000}, kHoldMax{16'000};

CreditPacer::CreditPacer(std::chrono::microseconds draw_interval)
    : draw_interval_ms_(std::max(0.001, draw_interval.count() / 1000.0)), hold_(kHoldMin) {}

void CreditPacer::restart() {
  on_their_way_ = 0;
  undrawn_ = 0;
  window_ = 1;
  rtt_ms_ = rtt_of_period_ms_ = 0;
  latency_ms_ = 0;
  hold_ = kHoldMin;
  may_grow_ = {};
}

// A heartbeat may have waited behind frames: the least tells the link's own round trip.
void CreditPacer::on_heartbeat(Time now, double rtt_ms) {
  if (now >= period_end_) {
    period_end_ = now + kRttPeriod;
    rtt_ms_ = rtt_of_period_ms_;
    rtt_of_period_ms_ = rtt_ms;
  }
  rtt_of_period_ms_ = std::min(rtt_of_period_ms_, rtt_ms);
  rtt_ms_ = rtt_ms_ > 0 ? std::min(rtt_ms_, rtt_of_period_ms_) : rtt_of_period_ms_;
}

void CreditPacer::on_frame(Time now, double latency_ms, double server_ms) {
  on_their_way_ = std::max(0, on_their_way_ - 1);
  ++undrawn_;
  if (latency_ms <= 0) return;
  const double weight = latency_ms_ > 0 ? kLatencyWeight : 1;
  latency_ms_ += weight * (latency_ms - latency_ms_);
  if (rtt_ms_ > 0) adapt_window(now, latency_ms - server_ms - rtt_ms_);
}

void CreditPacer::adapt_window(Time now, double queued_ms) {
  const int wanted =
      std::clamp(static_cast<int>(std::ceil(rtt_ms_ / draw_interval_ms_)), 1, kWindowMax);
  if (window_ > wanted) {
    window_ = wanted;
  } else if (window_ > 1 && queued_ms > kQueuedMsMax) {
    --window_;
    may_grow_ = now + hold_;
    hold_ = std::min(2 * hold_, kHoldMax);
  } else if (window_ < wanted && now >= may_grow_) {
    ++window_;
  }
}

void CreditPacer::on_drawn(Time now) {
  undrawn_ = 0;
  last_drawn_ = now;
}

int CreditPacer::missing() const {
  return std::max(0, window_ - undrawn_ - on_their_way_);
}

// With one frame on its way at a time there is a choice of when; with more the link is full.
CreditPacer::Time CreditPacer::earliest() const {
  if (window_ > 1 || latency_ms_ <= 0) return {};
  const double wait_ms = draw_interval_ms_ - latency_ms_ - kDrawMarginMs;
  if (wait_ms <= 0) return {};
  return last_drawn_ + std::chrono::microseconds(static_cast<int64_t>(wait_ms * 1000));
}

int CreditPacer::due(Time now) const {
  return now >= earliest() ? missing() : 0;
}

CreditPacer::Time CreditPacer::next_due() const {
  return missing() > 0 ? earliest() : Time::max();
}

}  // namespace burnish
