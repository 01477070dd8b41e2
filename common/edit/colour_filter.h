#pragma once

#include <string>

#include "common/base/limits.h"
#include "common/base/record.h"
#include "common/base/status.h"

namespace burnish {

/// The filter of a scan's colours over its surface: the same equation as for its shape, with a
/// metric and a gradient scale of its own. It works in linear light.
struct ColourFilter {
  double alpha = kAlphaDefault;  ///< fidelity weight, user units
  double beta = 1;               ///< gradient scale of unpainted colours; 1 keeps them
  bool operator==(const ColourFilter&) const = default;
};
BURNISH_RECORD(ColourFilter, beta, alpha)

/// Describes it in a few words: "colours at beta 0.2, alpha 50".
std::string text_of(const ColourFilter& filter);

/// Fails: invalid_argument for values outside their limits. The message names the value and the
/// limit.
Status check_colour_filter(const ColourFilter& filter);

}  // namespace burnish
