#include "client/scene/png_reader.h"

#include <png.h>

#include "common/base/mapped_file.h"

namespace burnish {

static Status damaged(const std::filesystem::path& path, const png_image& header) {
  return data_loss(path.string() + ": libpng: " + header.message);
}

Result<Image> read_png(const std::filesystem::path& path, int side_max) {
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(path));
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&header, file.bytes().data(), file.bytes().size()))
    return damaged(path, header);
  const auto max = static_cast<png_uint_32>(side_max);
  if (header.width > max || header.height > max) {
    const std::string size = std::to_string(header.width) + "x" + std::to_string(header.height);
    png_image_free(&header);
    return invalid_argument(path.string() + ": picture of " + size +
                            " pixels: both sides must be within " + std::to_string(side_max));
  }
  header.format = PNG_FORMAT_RGB;
  Image image{{static_cast<int>(header.width), static_cast<int>(header.height)}, {}};
  image.rgb.resize(PNG_IMAGE_SIZE(header));
  if (!png_image_finish_read(&header, nullptr, image.rgb.data(), 0, nullptr))
    return damaged(path, header);
  return image;
}

}  // namespace burnish
