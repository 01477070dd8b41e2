#include "common/picture/picture.h"

#include "common/picture/picture_rows.h"

namespace burnish {

Result<Picture> read_picture(std::span<const uint8_t> bytes, const std::string& name) {
  Picture picture;
  const auto begin = [&](const PictureSize& size) {
    picture.width = size.width;
    picture.height = size.height;
    picture.pixels.resize(size_t{size.width} * size.height);
    return Status::ok();
  };
  const auto take = [&](const PixelRun& run) {
    size_t at = size_t{run.y} * picture.width + run.first;
    for (const Rgba8& pixel : run.pixels) {
      picture.pixels[at] = pixel;
      at += run.step;
    }
  };
  RETURN_IF_ERROR(read_picture_rows(bytes, name, {begin, take}));
  return picture;
}

}  // namespace burnish
