#pragma once

#include "client/model/document.h"

namespace burnish {

/// Returns whether a brush has more to paint than β.
inline bool has_layers(const Document& document) {
  return document.has_colours() || !document.equaliser().bands.empty() ||
         !document.palette().curves.empty();
}

/// Draws the list of what the brush can paint: β, the gain of a band, a curve of the palette, the
/// colours.
void draw_painted_choice(Document& document);

}  // namespace burnish
