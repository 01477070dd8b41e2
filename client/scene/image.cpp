#include "client/scene/image.h"

#include <algorithm>
#include <charconv>

#include "common/base/limits.h"

namespace burnish {
namespace {

bool read_side(const char* begin, const char* end, int& side) {
  const auto [rest, error] = std::from_chars(begin, end, side);
  return error == std::errc() && rest == end;
}

}  // namespace

Status check_image_size(const ImageSize& size) {
  const auto is_outside = [](int side) {
    return side < kImageSidePixelsMin || side > kImageSidePixelsMax;
  };
  if (!is_outside(size.width) && !is_outside(size.height)) return Status::ok();
  return invalid_argument("picture of " + std::to_string(size.width) + "x" +
                          std::to_string(size.height) + " pixels: both sides must be within " +
                          std::to_string(kImageSidePixelsMin) + ".." +
                          std::to_string(kImageSidePixelsMax));
}

Result<ImageSize> parse_image_size(const std::string& text) {
  const char* const begin = text.data();
  const char* const end = begin + text.size();
  const size_t cross = std::min(text.find('x'), text.size());
  ImageSize size;
  if (cross == text.size() || !read_side(begin, begin + cross, size.width) ||
      !read_side(begin + cross + 1, end, size.height))
    return invalid_argument("'" + text + "' is not WIDTHxHEIGHT in pixels, such as 1280x960");
  RETURN_IF_ERROR(check_image_size(size));
  return size;
}

}  // namespace burnish
