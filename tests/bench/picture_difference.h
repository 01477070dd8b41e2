#pragma once

#include <Eigen/Core>

#include "client/scene/image.h"

namespace burnish {

/// How far two pictures of one size differ. Units: luminance, 0 to 255.
struct PictureDifference {
  double mean = 0;       ///< of the absolute difference, over all pixels
  int largest_blob = 0;  ///< pixels that touch, by a side, and differ by more than kBlobDifference
  Eigen::Vector2i blob_place = Eigen::Vector2i::Zero();  ///< one of its pixels
};

inline constexpr double kBlobDifference = 24;

/// Needs: pictures of one size.
PictureDifference compare_pictures(const Image& one, const Image& other);

/// Returns both pictures around a pixel and their difference, side by side and enlarged.
Image picture_close_up(const Image& one, const Image& other, const Eigen::Vector2i& place);

}  // namespace burnish
