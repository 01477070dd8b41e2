#pragma once

#include "client/scene/image.h"

namespace burnish {

/// How far two pictures of one size differ. Units: luminance, 0 to 255.
struct PictureDifference {
  double mean = 0;       ///< of the absolute difference, over all pixels
  int largest_blob = 0;  ///< pixels that touch, by a side, and differ by more than kBlobDifference
};

inline constexpr double kBlobDifference = 24;

/// Needs: pictures of one size.
PictureDifference compare_pictures(const Image& one, const Image& other);

}  // namespace burnish
