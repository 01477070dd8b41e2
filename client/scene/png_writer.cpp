#include "client/scene/png_writer.h"

#include <png.h>

#include "common/base/atomic_file.h"

namespace burnish {

static Result<std::vector<uint8_t>> encode_png(const Image& image) {
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.size.width);
  header.height = static_cast<png_uint_32>(image.size.height);
  header.format = PNG_FORMAT_RGB;
  std::vector<uint8_t> bytes(PNG_IMAGE_PNG_SIZE_MAX(header));
  png_alloc_size_t byte_count = bytes.size();
  if (!png_image_write_to_memory(&header, bytes.data(), &byte_count, 0, image.rgb.data(), 0,
                                 nullptr))
    return internal_error(std::string("libpng: ") + header.message);
  bytes.resize(byte_count);
  return bytes;
}

Status write_png(const Image& image, const std::filesystem::path& path) {
  RETURN_IF_ERROR(check_image_size(image.size));
  ASSIGN_OR_RETURN(const std::vector<uint8_t> bytes, encode_png(image));
  ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::create(path));
  RETURN_IF_ERROR(file.write(bytes));
  return file.commit();
}

}  // namespace burnish
