#pragma once

#include <chrono>
#include <cstdint>

namespace burnish {

/// Decides when a client asks for how many frames. A frame waits for nothing but the picture that
/// it is drawn in: one that was decoded and not drawn holds the next one back, and where a round
/// trip is shorter than a picture, the next is asked for as late as it may be.
/// The window of frames on their way at once is the round trip over the picture's interval, so that
/// each picture gets one; where frames wait for each other in the link, it is smaller.
class CreditPacer {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr int kWindowMax = 8;

  explicit CreditPacer(std::chrono::microseconds draw_interval);

  void restart();  ///< a new stream: nothing is granted
  void on_heartbeat(Time now, double rtt_ms);
  /// A frame has come. latency_ms: since it was asked for; 0 where nobody knows.
  void on_frame(Time now, double latency_ms, double server_ms);
  void on_drawn(Time now);

  int due(Time now) const;  ///< credits to grant now
  Time next_due() const;    ///< when one will be due, if nothing happens; Time::max(): never
  void granted(int credits) { on_their_way_ += credits; }
  int window() const { return window_; }

 private:
  int missing() const;
  Time earliest() const;
  void adapt_window(Time now, double queued_ms);

  const double draw_interval_ms_;
  int window_ = 1;
  int on_their_way_ = 0;
  int undrawn_ = 0;
  double latency_ms_ = 0;  // smoothed
  Time last_drawn_ = {};
  double rtt_ms_ = 0;  // the least of this period and the one before; 0: not known
  double rtt_of_period_ms_ = 0;
  Time period_end_ = {};
  Time may_grow_ = {};
  std::chrono::milliseconds hold_;  // how long the window stays small
};

}  // namespace burnish
