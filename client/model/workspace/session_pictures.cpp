#include "client/model/workspace/session_pictures.h"

#include <algorithm>

namespace burnish {

namespace fs = std::filesystem;

namespace {

/// A rectangle of pixels.
struct Block {
  int x = 0, y = 0, width = 0, height = 0;
};

}  // namespace

// Returns the largest block of this shape in the middle.
static Block middle_of(const ImageSize& whole, const ImageSize& shape) {
  const int width =
      std::min(whole.width, static_cast<int>(int64_t{whole.height} * shape.width / shape.height));
  const int height =
      std::min(whole.height, static_cast<int>(int64_t{whole.width} * shape.height / shape.width));
  return {(whole.width - width) / 2, (whole.height - height) / 2, width, height};
}

static void add_mean(const Image& image, const Block& block, std::vector<uint8_t>& rgb) {
  uint64_t sums[3] = {};
  for (int y = block.y; y < block.y + block.height; ++y)
    for (int x = block.x; x < block.x + block.width; ++x)
      for (int c = 0; c < 3; ++c) sums[c] += image.pixel(x, y)[c];
  const auto count = static_cast<uint64_t>(block.width) * static_cast<uint64_t>(block.height);
  for (const uint64_t sum : sums) rgb.push_back(static_cast<uint8_t>(sum / count));
}

Image shrunk(const Image& image, const ImageSize& size) {
  const Block all = middle_of(image.size, size);
  Image small{size, {}};
  small.rgb.reserve(3 * static_cast<size_t>(size.width) * static_cast<size_t>(size.height));
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const int left = all.x + x * all.width / size.width;
      const int top = all.y + y * all.height / size.height;
      const int right = all.x + (x + 1) * all.width / size.width;
      const int bottom = all.y + (y + 1) * all.height / size.height;
      add_mean(image, {left, top, std::max(1, right - left), std::max(1, bottom - top)}, small.rgb);
    }
  }
  return small;
}

fs::path picture_path(const fs::path& folder, const RecentSession& session) {
  const bool is_id =
      !session.id.empty() && session.id.find_first_not_of("0123456789abcdef") == std::string::npos;
  return is_id && !folder.empty() ? folder / (session.id + ".png") : fs::path();
}

}  // namespace burnish
