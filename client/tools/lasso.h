#pragma once

#include <vector>

#include "client/scene/camera.h"
#include "common/edit/protect.h"

namespace burnish {

/// Returns a region from a line that was drawn in a picture. Points beyond kLassoPointsMax are
/// thinned out evenly. Shapes: pixels from the upper left corner.
LassoRegion lasso_in_picture(const Camera& camera, const ImageSize& size,
                             const std::vector<Eigen::Vector2d>& pixels, bool through);

}  // namespace burnish
