#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

namespace burnish {

/// How large frames may be for the link to take no longer than kTransferMs for each, by what it
/// took for the last ones.
class FrameBudget {
 public:
  static constexpr double kTransferMs = 10;

  void restart() { bytes_per_ms_.clear(); }

  /// A frame of so many bytes was so long in the link, beyond what a small message takes.
  void on_frame(size_t bytes, double transfer_ms);

  /// Returns 0 while it is not known.
  uint32_t bytes() const;

 private:
  std::deque<double> bytes_per_ms_;  // of the last frames
};

}  // namespace burnish
