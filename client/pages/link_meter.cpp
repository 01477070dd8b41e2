#include "client/pages/link_meter.h"

#include <algorithm>

namespace burnish {

static constexpr size_t kSamplesRemembered = 8;
static constexpr double kSampleBytes = 32 * 1024;  // fewer say more of the jitter than of the link

void LinkMeter::on_part(size_t bytes, Time now) {
  if (receiving_ == 0) return;
  sample_.bytes += static_cast<double>(bytes);
  sample_.seconds += std::chrono::duration<double>(now - last_).count();
  last_ = now;
  if (sample_.bytes < kSampleBytes) return;
  samples_.push_back(sample_);
  sample_ = {};
  if (samples_.size() > kSamplesRemembered) samples_.pop_front();
}

void LinkMeter::on_first_part(Time began, Time now) {
  if (++receiving_ == 1) last_ = now;
  round_trips_.push_back(std::chrono::duration<double>(now - began).count());
  if (round_trips_.size() > kSamplesRemembered) round_trips_.pop_front();
}

LinkSpeed LinkMeter::speed() const {
  LinkSpeed speed;
  if (!round_trips_.empty()) speed.round_trip_seconds = *std::ranges::min_element(round_trips_);
  Sample sum;
  for (const Sample& sample : samples_) {
    sum.bytes += sample.bytes;
    sum.seconds += sample.seconds;
  }
  if (sum.seconds > 0) speed.bytes_per_second = sum.bytes / sum.seconds;
  return speed;
}

}  // namespace burnish
