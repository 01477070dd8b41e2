#include "common/picture/png_reading.h"

#include <algorithm>

namespace burnish {

[[noreturn]] static void leave_reading(png_structp png, png_const_charp message) {
  static_cast<PngReading*>(png_get_error_ptr(png))->message = message;
  png_longjmp(png, 1);
}

static void ignore_warning(png_structp, png_const_charp) {}

static void give_bytes(png_structp png, png_bytep to, size_t count) {
  auto& left = static_cast<PngReading*>(png_get_io_ptr(png))->left;
  if (count > left.size()) png_error(png, "the file ends early");
  std::copy_n(left.begin(), count, to);
  left = left.subspan(count);
}

PngReading::PngReading(std::span<const uint8_t> file) : left(file) {
  png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, leave_reading, ignore_warning);
  if (png == nullptr) return;
  info = png_create_info_struct(png);
  png_set_read_fn(png, this, give_bytes);
}

Status PngReading::failure() const {
  if (is_cancelled) return cancelled("decoding was cancelled");
  if (info == nullptr) return resource_exhausted("not enough memory for libpng");
  return invalid_argument("libpng: " + message);
}

bool read_png_header(PngReading& reading) {
  if (reading.info == nullptr || setjmp(png_jmpbuf(reading.png)) != 0) return false;
  png_read_info(reading.png, reading.info);
  return true;
}

}  // namespace burnish
