#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace burnish {

/// Tells cut-off calls from calls whose message is still on its way: the latter are few for a
/// moment, the former stay missing. gRPC reports neither.
class CutOffCalls {
 public:
  /// `missing`: calls that have arrived and not started so far. Returns how many more of them than
  /// at the last call have been missing for several calls.
  uint64_t add(uint64_t missing) {
    window_[next_++ % window_.size()] = missing;
    const uint64_t lost = *std::min_element(window_.begin(), window_.end());
    const uint64_t fresh = lost > told_ ? lost - told_ : 0;
    told_ += fresh;
    return fresh;
  }

 private:
  std::array<uint64_t, 4> window_ = {};
  size_t next_ = 0;
  uint64_t told_ = 0;
};

}  // namespace burnish
