#pragma once

#include <string>

#include "client/scene/image.h"
#include "client/scene/scale_bar.h"

namespace burnish {

/// Writes words into the lower left corner of a picture, and makes them its note. A picture that is
/// too narrow shows their beginning. Needs: letters of ASCII, digits, spaces and ",.%".
void mark_picture(Image& image, const std::string& words);

/// Draws a scale bar with its length in words into the lower right corner, over a note that reaches
/// as far. A letter that is not in ASCII becomes a question mark, but "µ" stays.
void draw_scale_bar(Image& image, const ScaleBar& bar, const std::string& words);

}  // namespace burnish
