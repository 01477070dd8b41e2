#include <string>
#include <vector>

#include "common/picture/jpeg_decoding.h"
#include "common/picture/picture_formats.h"

namespace burnish {

namespace {

/// Each step returns false where libjpeg failed.
bool begin_rows(JpegDecoding& decoding) {
  if (setjmp(decoding.failed) != 0) return false;
  decoding.jpeg.out_color_space = JCS_EXT_RGBA;
  jpeg_start_decompress(&decoding.jpeg);
  return true;
}

bool read_row(JpegDecoding& decoding, Rgba8* pixels) {
  if (setjmp(decoding.failed) != 0) return false;
  JSAMPROW row = reinterpret_cast<JSAMPROW>(pixels);
  jpeg_read_scanlines(&decoding.jpeg, &row, 1);
  return true;
}

bool end_rows(JpegDecoding& decoding) {
  if (setjmp(decoding.failed) != 0) return false;
  jpeg_finish_decompress(&decoding.jpeg);
  return true;
}

/// A file of several scans has its coefficients in memory until the last scan has been read.
uint64_t decoding_bytes_of(jpeg_decompress_struct& jpeg) {
  const bool keeps_all = jpeg_has_multiple_scans(&jpeg) != FALSE;
  return jpeg_row_bytes(jpeg) + (keeps_all ? jpeg_coefficient_bytes(jpeg) : 0);
}

}  // namespace

Status read_jpeg_rows(std::span<const uint8_t> bytes, const PictureTaker& taker) {
  JpegDecoding decoding(taker);
  if (!read_jpeg_header(decoding, bytes)) return decoding.failure();
  auto& jpeg = decoding.jpeg;
  if (jpeg.num_components != 1 && jpeg.num_components != 3)
    return unimplemented("the JPEG has " + std::to_string(jpeg.num_components) +
                         " colour channels; only 1 and 3 are read");
  const PictureSize size{jpeg.image_width, jpeg.image_height, decoding_bytes_of(jpeg)};
  RETURN_IF_ERROR(begin_picture(size, bytes.size(), taker));
  std::vector<Rgba8> row(size.width);
  if (!begin_rows(decoding)) return decoding.failure();
  for (uint32_t y = 0; y < size.height; ++y) {
    if (!read_row(decoding, row.data())) return decoding.failure();
    taker.take({y, 0, 1, row});
  }
  if (!end_rows(decoding)) return decoding.failure();
  if (decoding.is_cut) return invalid_argument("the JPEG ends before its last row");
  return Status::ok();
}

}  // namespace burnish
