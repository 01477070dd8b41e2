#pragma once

#include <optional>

#include "client/scene/camera.h"
#include "client/scene/image.h"

namespace burnish {

/// A bar of a round length, to be laid over a picture.
struct ScaleBar {
  double length;       ///< file units: 1, 2 or 5 times a power of ten
  double pixels;       ///< of the picture
  double pixel_ratio;  ///< pixels of the picture for one of a screen with 96 dots per inch
};

/// Returns the pixel ratio of a picture that is for no screen: it grows with the picture's height.
double pixel_ratio_of(const ImageSize& size);

/// Returns the bar of a picture: 72 to 180 pixels of a screen with 96 dots per inch, and at most
/// half of the picture's width. With perspective it holds at the distance of the camera's target.
/// Returns nothing where no length can be told.
std::optional<ScaleBar> scale_bar(const Camera& camera, const ImageSize& size, double pixel_ratio);

}  // namespace burnish
