#include "tests/bench/picture_difference.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/base/check.h"

namespace burnish {

static double luminance(const uint8_t* rgb) {
  return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

// Counts and clears the set pixels that hang together with this one.
static int take_blob(std::vector<uint8_t>& is_set, const ImageSize& size, int start) {
  std::vector<int> open = {start};
  is_set[start] = 0;
  int count = 0;
  const auto visit = [&](int pixel) {
    if (!is_set[pixel]) return;
    is_set[pixel] = 0;
    open.push_back(pixel);
  };
  while (!open.empty()) {
    const int pixel = open.back();
    open.pop_back();
    ++count;
    const int x = pixel % size.width, y = pixel / size.width;
    if (x > 0) visit(pixel - 1);
    if (x + 1 < size.width) visit(pixel + 1);
    if (y > 0) visit(pixel - size.width);
    if (y + 1 < size.height) visit(pixel + size.width);
  }
  return count;
}

PictureDifference compare_pictures(const Image& one, const Image& other) {
  BURNISH_CHECK(one.size == other.size, "pictures of one size");
  const int pixels = one.size.width * one.size.height;
  std::vector<uint8_t> is_set(pixels);
  double sum = 0;
  for (int p = 0; p < pixels; ++p) {
    const double difference = std::abs(luminance(&one.rgb[3 * p]) - luminance(&other.rgb[3 * p]));
    sum += difference;
    is_set[p] = difference > kBlobDifference;
  }
  PictureDifference result{sum / pixels};
  for (int p = 0; p < pixels; ++p) {
    if (!is_set[p]) continue;
    const int blob = take_blob(is_set, one.size, p);
    if (blob <= result.largest_blob) continue;
    result.largest_blob = blob;
    result.blob_place = {p % one.size.width, p / one.size.width};
  }
  return result;
}

Image picture_close_up(const Image& one, const Image& other, const Eigen::Vector2i& place) {
  constexpr int kSide = 80, kFactor = 5, kTile = kSide * kFactor;
  Image picture{{3 * kTile, kTile}, std::vector<uint8_t>(size_t{9} * kTile * kTile)};
  const int left = std::clamp(place.x() - kSide / 2, 0, one.size.width - kSide);
  const int top = std::clamp(place.y() - kSide / 2, 0, one.size.height - kSide);
  for (int y = 0; y < kTile; ++y) {
    for (int x = 0; x < 3 * kTile; ++x) {
      const int from_x = left + x % kTile / kFactor, from_y = top + y / kFactor;
      const uint8_t* a = one.pixel(from_x, from_y);
      const uint8_t* b = other.pixel(from_x, from_y);
      uint8_t* to = &picture.rgb[3 * (size_t(y) * 3 * kTile + x)];
      for (int c = 0; c < 3; ++c) {
        const int difference = std::min(4 * std::abs(a[c] - b[c]), 255);
        to[c] = x < kTile ? a[c] : x < 2 * kTile ? b[c] : static_cast<uint8_t>(difference);
      }
    }
  }
  return picture;
}

}  // namespace burnish
