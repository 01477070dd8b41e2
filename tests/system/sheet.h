#pragma once

#include <vector>

#include "client/scene/image.h"

namespace burnish {

/// Part of a picture, pixels from its upper left corner.
struct Box {
  int x = 0, y = 0, width = 0, height = 0;
};

Box scaled(const Box& box, int factor);

/// Needs: a box within the picture.
Image cut(const Image& image, const Box& box);

/// Returns the image at half size: each pixel is the mean of four.
Image halved(const Image& image);

/// Returns tiles of one size on white, `columns` in a row, with a gap between.
Image in_rows(const std::vector<Image>& tiles, int columns);

}  // namespace burnish
