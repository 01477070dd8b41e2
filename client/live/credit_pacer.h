#pragma once

#include <chrono>
#include <cstdint>
#include <deque>

namespace burnish {

/// Decides when a client asks for how many frames. A frame waits for nothing but the picture that
/// it is drawn in: one that was decoded and not drawn holds the next one back, and where a round
/// trip is shorter than a picture, the next is asked for as late as it may be.
/// The window of frames on their way at once is the round trip over the interval of frames, be it
/// the reader's or the server's; where frames wait for each other in the link, it is smaller.
class CreditPacer {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr int kWindowMax = 8;

  explicit CreditPacer(std::chrono::microseconds draw_interval);

  void restart();  ///< a new stream: nothing is granted
  void on_heartbeat(Time now, double rtt_ms);
  /// A frame has come, which the server made in so long. The newest heartbeat that it has seen and
  /// the frame itself were in the link for `link_ms` together; 0: it has seen none.
  void on_frame(Time now, double link_ms, double server_ms);
  void on_drawn(Time now);
  void set_draw_interval(std::chrono::microseconds interval);

  int due(Time now) const;  ///< credits to grant now
  Time next_due() const;    ///< when one will be due, if nothing happens; Time::max(): never
  void granted(Time now, int credits) { granted_.insert(granted_.end(), credits, now); }
  int window() const { return window_; }
  double rtt_ms() const { return rtt_ms_; }  ///< of the link alone; 0: not known

 private:
  int missing() const;
  Time earliest() const;
  void learn_latency(double ms);
  void adapt_window(Time now, double queued_ms);

  double draw_interval_ms_;
  int window_ = 1;
  std::deque<Time> granted_;  // when, of credits whose frames have not come
  int undrawn_ = 0;
  double latency_ms_ = 0;    // from a credit to its frame, smoothed; 0: not known
  double deviation_ms_ = 0;  // of that
  double server_ms_ = 0;     // that it takes for a frame, smoothed
  Time last_drawn_ = {};
  double rtt_ms_ = 0;  // the least of this period and the one before; 0: not known
  double rtt_of_period_ms_ = 0;
  Time period_end_ = {};
  std::deque<double> queued_ms_;  // of the last frames: how long each may have waited in the link
  Time may_grow_ = {};
  std::chrono::milliseconds hold_;  // how long the window stays small
};

}  // namespace burnish
