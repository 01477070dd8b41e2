#pragma once

#include <functional>
#include <string_view>

namespace burnish {

/// Long work calls this from time to time with the phase's name and the done fraction in [0, 1].
/// Returns false to cancel; the work then ends soon with StatusCode::kCancelled. May be empty. The
/// call comes from the thread that started the work.
using Progress = std::function<bool(std::string_view phase, double fraction)>;

/// Reports to `progress` if there is one. Returns true to go on.
inline bool report(const Progress& progress, std::string_view phase, double fraction) {
  return !progress || progress(phase, fraction);
}

}  // namespace burnish
