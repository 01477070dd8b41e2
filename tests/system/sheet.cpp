#include "tests/system/sheet.h"

#include <algorithm>

#include "common/base/check.h"

namespace burnish {

static constexpr int kGap = 6;

static uint8_t* pixel_at(Image& image, int x, int y) {
  return image.rgb.data() + 3 * (static_cast<size_t>(y) * image.size.width + x);
}

static Image white(const ImageSize& size) {
  return {size, std::vector<uint8_t>(size_t{3} * size.width * size.height, 255)};
}

Box scaled(const Box& box, int factor) {
  return {factor * box.x, factor * box.y, factor * box.width, factor * box.height};
}

Image cut(const Image& image, const Box& box) {
  BURNISH_CHECK(box.x >= 0 && box.y >= 0 && box.x + box.width <= image.size.width &&
                    box.y + box.height <= image.size.height,
                "the box is not within the picture");
  Image part = white({box.width, box.height});
  for (int y = 0; y < box.height; ++y)
    std::copy_n(image.pixel(box.x, box.y + y), 3 * box.width, pixel_at(part, 0, y));
  return part;
}

Image halved(const Image& image) {
  Image half = white({image.size.width / 2, image.size.height / 2});
  for (int y = 0; y < half.size.height; ++y) {
    for (int x = 0; x < half.size.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const int sum = image.pixel(2 * x, 2 * y)[c] + image.pixel(2 * x + 1, 2 * y)[c] +
                        image.pixel(2 * x, 2 * y + 1)[c] + image.pixel(2 * x + 1, 2 * y + 1)[c];
        pixel_at(half, x, y)[c] = static_cast<uint8_t>((sum + 2) / 4);
      }
    }
  }
  return half;
}

Image in_rows(const std::vector<Image>& tiles, int columns) {
  const ImageSize tile = tiles.front().size;
  const int count = static_cast<int>(tiles.size());
  const int rows = (count + columns - 1) / columns;
  Image sheet = white({columns * (tile.width + kGap) - kGap, rows * (tile.height + kGap) - kGap});
  for (int i = 0; i < count; ++i) {
    const int left = i % columns * (tile.width + kGap), top = i / columns * (tile.height + kGap);
    for (int y = 0; y < tile.height; ++y)
      std::copy_n(tiles[static_cast<size_t>(i)].pixel(0, y), 3 * tile.width,
                  pixel_at(sheet, left, top + y));
  }
  return sheet;
}

}  // namespace burnish
