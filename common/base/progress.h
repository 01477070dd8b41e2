#pragma once

#include <functional>
#include <string_view>

namespace burnish {

/// Called from time to time by long work: the phase's name and its done fraction in [0, 1].
/// Returns false to cancel; the work then ends soon with StatusCode::kCancelled.
/// May be empty. Always called from the thread that started the work.
using Progress = std::function<bool(std::string_view phase, double fraction)>;

/// Reports to `progress` if there is one; true means go on.
inline bool report(const Progress& progress, std::string_view phase, double fraction) {
  return !progress || progress(phase, fraction);
}

}  // namespace burnish
