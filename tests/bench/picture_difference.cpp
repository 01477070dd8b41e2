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
    const double difference =
        std::abs(luminance(&one.rgb[3 * p]) - luminance(&other.rgb[3 * p]));
    sum += difference;
    is_set[p] = difference > kBlobDifference;
  }
  PictureDifference result{sum / pixels, 0};
  for (int p = 0; p < pixels; ++p)
    if (is_set[p])
      result.largest_blob = std::max(result.largest_blob, take_blob(is_set, one.size, p));
  return result;
}

}  // namespace burnish
