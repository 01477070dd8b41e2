#pragma once

#include <cmath>

#include "client/scene/image.h"
#include "common/base/check.h"

namespace burnish {

/// Returns the root of the mean square difference of two pictures' bytes, as a part of 255.
inline double picture_rmse(const Image& a, const Image& b) {
  BURNISH_CHECK(a.size == b.size, "pictures of one size");
  double sum = 0;
  for (size_t i = 0; i < a.rgb.size(); ++i) {
    const double difference = a.rgb[i] - b.rgb[i];
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(a.rgb.size())) / 255;
}

}  // namespace burnish
