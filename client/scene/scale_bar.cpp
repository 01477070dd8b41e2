#include "client/scene/scale_bar.h"

#include <algorithm>
#include <cmath>

#include "common/base/round_number.h"

namespace burnish {

static constexpr double kBarPixelsMax = 180;  // of a screen with 96 dots per inch
static constexpr double kBarPartMax = 0.5;    // of the picture's width
static constexpr double kRowsOfScreen = 700;  // a picture with so many rows has ratio 1
static constexpr double kPixelRatioMin = 0.5;

double pixel_ratio_of(const ImageSize& size) {
  return std::max(kPixelRatioMin, size.height / kRowsOfScreen);
}

std::optional<ScaleBar> scale_bar(const Camera& camera, const ImageSize& size, double pixel_ratio) {
  const double pixels_max = std::min(kBarPixelsMax * pixel_ratio, kBarPartMax * size.width);
  const double pixel = pixel_length(camera, size), limit = pixels_max * pixel;
  if (!std::isnormal(limit) || limit < 0 || !std::isnormal(pixel)) return std::nullopt;
  const double length = round_number_below(limit);
  return ScaleBar{length, length / pixel, pixel_ratio};
}

}  // namespace burnish
