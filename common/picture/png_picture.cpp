#include <vector>

#include "common/picture/picture_formats.h"
#include "common/picture/png_reading.h"

namespace burnish {

namespace {

constexpr uint64_t kPngDecoderBytes = uint64_t{1} << 18;  // zlib's window, libpng's buffers
constexpr uint64_t kPngBytesPerColumn = 3 * 8 + 4;        // three rows of 16 bits, one of ours

/// A decoding, and the row that it is at. Each step returns false where libpng failed.
struct PngDecoding : PngReading {
  using PngReading::PngReading;
  std::vector<Rgba8> row;
};

/// Asks for sRGB with alpha in 8 bits a channel. A file that does not say its gamma is in sRGB.
bool choose_pixels(PngDecoding& decoding) {
  png_structp png = decoding.png;
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_alpha_mode(png, PNG_ALPHA_PNG, PNG_DEFAULT_sRGB);
  png_set_expand(png);
  png_set_gray_to_rgb(png);
  png_set_scale_16(png);
  png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
  png_read_update_info(png, decoding.info);
  return png_get_rowbytes(png, decoding.info) ==
         sizeof(Rgba8) * size_t{png_get_image_width(png, decoding.info)};
}

bool read_row(PngDecoding& decoding) {
  if (setjmp(png_jmpbuf(decoding.png)) != 0) return false;
  png_read_row(decoding.png, reinterpret_cast<png_bytep>(decoding.row.data()), nullptr);
  return true;
}

/// A pass of an interlaced picture, or the whole of another.
struct Pass {
  uint32_t first_row = 0, row_step = 1;
  uint32_t first = 0, step = 1;
};

std::vector<Pass> passes_of(bool is_interlaced) {
  if (!is_interlaced) return {Pass{}};
  std::vector<Pass> passes;
  for (int p = 0; p < PNG_INTERLACE_ADAM7_PASSES; ++p)
    passes.push_back({.first_row = static_cast<uint32_t>(PNG_PASS_START_ROW(p)),
                      .row_step = static_cast<uint32_t>(PNG_PASS_ROW_OFFSET(p)),
                      .first = static_cast<uint32_t>(PNG_PASS_START_COL(p)),
                      .step = static_cast<uint32_t>(PNG_PASS_COL_OFFSET(p))});
  return passes;
}

bool read_pass(PngDecoding& decoding, const Pass& pass, const PictureSize& size,
               const PictureTaker& taker) {
  if (pass.first >= size.width) return true;
  const size_t columns = (size.width - pass.first + pass.step - 1) / pass.step;
  for (uint32_t y = pass.first_row; y < size.height; y += pass.row_step) {
    decoding.is_cancelled = taker.goes_on && !taker.goes_on();
    if (decoding.is_cancelled || !read_row(decoding)) return false;
    taker.take({y, pass.first, pass.step, std::span(decoding.row).first(columns)});
  }
  return true;
}

}  // namespace

Status read_png_rows(std::span<const uint8_t> bytes, const PictureTaker& taker) {
  PngDecoding decoding(bytes);
  if (!read_png_header(decoding)) return decoding.failure();
  PictureSize size{png_get_image_width(decoding.png, decoding.info),
                   png_get_image_height(decoding.png, decoding.info), kPngDecoderBytes};
  size.decoding_bytes += size.width * kPngBytesPerColumn;
  RETURN_IF_ERROR(begin_picture(size, bytes.size(), taker));
  if (!choose_pixels(decoding)) return decoding.failure();
  decoding.row.resize(size.width);
  for (const Pass& pass : passes_of(decoding.is_interlaced()))
    if (!read_pass(decoding, pass, size, taker)) return decoding.failure();
  return Status::ok();
}

}  // namespace burnish
