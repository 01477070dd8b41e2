#include "client/scene/png_writer.h"

#include <png.h>
#include <zlib.h>

#include "client/scene/png_note.h"
#include "common/base/atomic_file.h"

namespace burnish {

static constexpr size_t kHeadBytes = 33;  // of a PNG: notes may follow

static void add_big_endian(uint32_t value, std::string& bytes) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255);
}

// Writes the note itself: libpng does so only where the rows are handed over one by one.
static void insert_note(std::string_view note, std::vector<uint8_t>& png) {
  const std::string content = png_note(note), named = "tEXt" + content;
  std::string part;
  add_big_endian(static_cast<uint32_t>(content.size()), part);
  part += named;
  const uLong crc =
      crc32(0, reinterpret_cast<const Bytef*>(named.data()), static_cast<uInt>(named.size()));
  add_big_endian(static_cast<uint32_t>(crc), part);
  png.insert(png.begin() + kHeadBytes, part.begin(), part.end());
}

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
  if (!image.note.empty()) insert_note(image.note, bytes);
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
