#include "client/live/frame_budget.h"

#include <algorithm>
#include <vector>

namespace burnish {

static constexpr size_t kFramesRemembered = 7;
static constexpr size_t kTellingBytes = 4096;  // less goes with the jitter
static constexpr double kTransferMsMin = 0.2;

void FrameBudget::on_frame(size_t bytes, double transfer_ms) {
  if (bytes < kTellingBytes) return;
  bytes_per_ms_.push_back(static_cast<double>(bytes) / std::max(transfer_ms, kTransferMsMin));
  if (bytes_per_ms_.size() > kFramesRemembered) bytes_per_ms_.pop_front();
}

// The median: a frame may have waited for others, or a lost packet.
uint32_t FrameBudget::bytes() const {
  if (bytes_per_ms_.empty()) return 0;
  std::vector<double> rates(bytes_per_ms_.begin(), bytes_per_ms_.end());
  const auto middle = rates.begin() + static_cast<std::ptrdiff_t>(rates.size() / 2);
  std::ranges::nth_element(rates, middle);
  return static_cast<uint32_t>(std::clamp(*middle * kTransferMs, 1.0, 1e9));
}

}  // namespace burnish
