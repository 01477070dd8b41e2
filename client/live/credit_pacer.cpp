#include "client/live/credit_pacer.h"

#include <algorithm>
#include <cmath>

namespace burnish {

using std::chrono::milliseconds;

static constexpr auto kRttPeriod = std::chrono::seconds(10);
static constexpr double kQueuedMsMax = 12;  // more than jitter
static constexpr double kDrawMarginMs = 4;  // a frame comes so much before its picture
static constexpr size_t kFramesObserved = 5;
static constexpr double kDeviations = 4;
static constexpr double kLatencyWeight = 0.2;
static constexpr milliseconds kHoldMin{1000}, kHoldMax{16'000};

CreditPacer::CreditPacer(std::chrono::microseconds draw_interval) : hold_(kHoldMin) {
  set_draw_interval(draw_interval);
}

void CreditPacer::set_draw_interval(std::chrono::microseconds interval) {
  draw_interval_ms_ = std::max(0.001, static_cast<double>(interval.count()) / 1000);
}

void CreditPacer::restart() {
  granted_.clear();
  undrawn_ = 0;
  window_ = 1;
  rtt_ms_ = rtt_of_period_ms_ = 0;
  latency_ms_ = deviation_ms_ = 0;
  queued_ms_.clear();
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

void CreditPacer::on_frame(Time now, double link_ms, double server_ms) {
  ++undrawn_;
  if (!granted_.empty()) {
    learn_latency(std::chrono::duration<double, std::milli>(now - granted_.front()).count());
    granted_.pop_front();
  }
  server_ms_ += kLatencyWeight * (server_ms - server_ms_);
  if (link_ms > 0 && rtt_ms_ > 0) adapt_window(now, link_ms - rtt_ms_);
}

// A frame that came late because nothing moved says nothing: it counts as a picture's interval.
void CreditPacer::learn_latency(double ms) {
  const double counted_ms = std::min(ms, draw_interval_ms_);
  if (latency_ms_ == 0) latency_ms_ = counted_ms;
  const double change_ms = counted_ms - latency_ms_;
  latency_ms_ += kLatencyWeight * change_ms;
  deviation_ms_ += kLatencyWeight * (std::abs(change_ms) - deviation_ms_);
}

// A frame may also be a large one: what all of the last few have waited at least is what frames
// wait for each other.
void CreditPacer::adapt_window(Time now, double queued_ms) {
  queued_ms_.push_back(queued_ms);
  if (queued_ms_.size() > kFramesObserved) queued_ms_.pop_front();
  const double interval_ms = std::max(draw_interval_ms_, server_ms_);
  const int wanted = std::clamp(static_cast<int>(std::ceil(rtt_ms_ / interval_ms)), 1, kWindowMax);
  if (window_ > wanted) {
    window_ = wanted;
  } else if (window_ > 1 && queued_ms_.size() == kFramesObserved &&
             *std::ranges::min_element(queued_ms_) > kQueuedMsMax) {
    --window_;
    queued_ms_.clear();
    may_grow_ = now + hold_;
    hold_ = std::min(2 * hold_, kHoldMax);
  } else if (window_ < wanted && now >= may_grow_) {
    ++window_;
  }
}

// Somebody who looks more often than pictures are drawn must not put the next frame off each time.
void CreditPacer::on_drawn(Time now) {
  const std::chrono::duration<double, std::milli> since_last = now - last_drawn_;
  if (undrawn_ > 0 || since_last.count() >= draw_interval_ms_) last_drawn_ = now;
  undrawn_ = 0;
}

int CreditPacer::missing() const {
  return std::max(0, window_ - undrawn_ - static_cast<int>(granted_.size()));
}

// With one frame on its way at a time there is a choice of when; with more the link is full.
CreditPacer::Time CreditPacer::earliest() const {
  if (window_ > 1 || latency_ms_ <= 0) return {};
  const double wait_ms =
      draw_interval_ms_ - latency_ms_ - kDeviations * deviation_ms_ - kDrawMarginMs;
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
