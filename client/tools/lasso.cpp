#include "client/tools/lasso.h"

#include <algorithm>

namespace burnish {

LassoRegion lasso_in_picture(const Camera& camera, const ImageSize& size,
                             const std::vector<Eigen::Vector2d>& pixels, bool through) {
  LassoRegion lasso;
  Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(lasso.view_projection.data()) =
      projection_matrix(camera, size.aspect()) * view_matrix(camera);
  lasso.through = through;
  const size_t points = std::min(pixels.size(), kLassoPointsMax);
  for (size_t i = 0; i < points; ++i) {
    const Eigen::Vector2d& pixel = pixels[i * pixels.size() / points];
    lasso.polygon.emplace_back(2 * pixel.x() / size.width - 1, 1 - 2 * pixel.y() / size.height);
  }
  return lasso;
}

}  // namespace burnish
