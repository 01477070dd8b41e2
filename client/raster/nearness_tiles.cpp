#include "client/raster/nearness_tiles.h"

#include <algorithm>

namespace burnish {

static constexpr int kTilePixels = 4;
static constexpr float kRounding = 1e-5f;  // of nearness, by far more than floats differ

static float farthest_in(const Visibility& visibility, int left, int top) {
  const int right = std::min(left + kTilePixels, visibility.size.width);
  const int bottom = std::min(top + kTilePixels, visibility.size.height);
  SampleKey farthest = ~SampleKey{0};
  for (int y = top; y < bottom; ++y) {
    const SampleKey* const first = visibility.keys.data() + visibility.place(left, y);
    const SampleKey* const end = visibility.keys.data() + visibility.place(right, y);
    for (const SampleKey* key = first; key < end; ++key) farthest = std::min(farthest, *key);
    if (farthest == kNothingSeen) return 0;
  }
  return nearness_of_key(farthest);
}

void NearnessTiles::measure(const Visibility& visibility, WorkCrew& crew) {
  across_ = (visibility.size.width + kTilePixels - 1) / kTilePixels;
  const int down = (visibility.size.height + kTilePixels - 1) / kTilePixels;
  farthest_.resize(size_t(across_) * down);
  crew.run(down, [&](int row) {
    for (int column = 0; column < across_; ++column)
      farthest_[size_t(row) * across_ + column] =
          farthest_in(visibility, column * kTilePixels, row * kTilePixels);
  });
}

bool NearnessTiles::hide(const ScreenBox& box) const {
  const float nearest = box.nearness + kRounding;
  for (int row = box.top / kTilePixels; row <= box.bottom / kTilePixels; ++row)
    for (int column = box.left / kTilePixels; column <= box.right / kTilePixels; ++column)
      if (farthest_[size_t(row) * across_ + column] <= nearest) return false;
  return true;
}

}  // namespace burnish
