#include "client/pages/picture_pace.h"

#include <algorithm>
#include <cmath>

namespace burnish {

/// Parts of kPictureMs. A picture between them changes nothing, so that the cut does not flicker.
static constexpr double kSlow = 1.3, kFast = 0.6;
/// As many as cards draw that need no limit.
static constexpr double kTrianglesAny = 2e6;

// Half of the way, as ratios: a single picture may have waited for something else.
static uint64_t between(uint64_t last, double now) {
  return static_cast<uint64_t>(std::sqrt(static_cast<double>(last) * now));
}

void PicturePace::on_picture(uint64_t triangles, double ms) {
  if (triangles == 0) return;  // it was another scan's picture
  const double drawn = static_cast<double>(triangles);
  const double in_time = drawn * kPictureMs / std::max(ms, 1.0);
  if (ms > kSlow * kPictureMs) {
    const uint64_t last = triangles_max_ == 0 ? triangles : std::min(triangles_max_, triangles);
    triangles_max_ = std::max(between(last, in_time), kTrianglesMin);
  } else if (triangles_max_ > 0 && ms < kFast * kPictureMs && 2 * triangles > triangles_max_) {
    triangles_max_ = std::max(between(triangles_max_, in_time), triangles_max_);
    if (static_cast<double>(triangles_max_) > kTrianglesAny) triangles_max_ = 0;
  }
}

}  // namespace burnish
