#pragma once

#include <optional>
#include <string>

#include "client/model/view/viewport.h"

namespace burnish {

/// The meaning of a picture's colours: texts at -1, 0 and 1, and the value under the pointer.
struct ColourScale {
  std::string title, low, middle, high;
  double part = 0;    ///< of the pointer, -1 to 1
  std::string value;  ///< at the pointer; empty: it is not on the surface
};

/// Returns nothing where colours are no values.
std::optional<ColourScale> colour_scale(const Document& document, const Viewport& viewport);

}  // namespace burnish
