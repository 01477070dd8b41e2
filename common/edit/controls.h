#pragma once

#include <string>

#include "common/base/record.h"
#include "common/base/status.h"

namespace burnish {

/// Bounds on what edits do to a surface, whatever the edits are.
struct Controls {
  bool pin_rims = false;     ///< the rims of an open surface stay where they are
  double cap = 0;            ///< nothing moves more than this; file units, 0: as far as it likes
  bool keep_volume = false;  ///< a closed surface keeps its volume
  bool operator==(const Controls&) const = default;
};
BURNISH_RECORD(Controls, pin_rims, cap, keep_volume)

/// The controls of a new session.
inline constexpr Controls kNewSessionControls{.pin_rims = true};

/// Describes them in a few words: "rims pinned, at most 0.5, volume kept".
std::string text_of(const Controls& controls);

/// Returns whether a volume over the scan's is 1, except for rounding: within 1e-6.
bool is_volume_kept(double volume);

/// Says how much of the volume an edited surface has, and why it has not all of it. Empty if it was
/// kept. Takes the volume over the scan's.
std::string lost_volume_text(double volume, const Controls& controls);

/// Fails: invalid_argument if the cap is outside 0 to kCoordinateMagnitudeMax.
Status check_controls(const Controls& controls);

}  // namespace burnish
