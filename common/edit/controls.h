#pragma once

#include <string>

#include "common/base/status.h"

namespace burnish {

/// Bounds on what edits do to a surface, whatever the edits are.
struct Controls {
  bool pin_rims = false;     ///< the rims of an open surface stay where they are
  double cap = 0;            ///< nothing moves more than this; file units, 0: as far as it likes
  bool keep_volume = false;  ///< a closed surface keeps its volume
  bool operator==(const Controls&) const = default;
};

/// The controls of a new session.
inline constexpr Controls kNewSessionControls{.pin_rims = true};

/// Describes them in a few words: "rims pinned, at most 0.5, volume kept".
std::string text_of(const Controls& controls);

/// Fails: invalid_argument if the cap is outside 0 to kCoordinateMagnitudeMax.
Status check_controls(const Controls& controls);

}  // namespace burnish
