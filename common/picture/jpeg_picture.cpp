#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <jerror.h>
#include <jpeglib.h>
#include <vector>

#include "common/picture/picture_formats.h"

namespace burnish {

namespace {

constexpr int kScansMax = 100;  // a small progressive file may ask for thousands of passes
constexpr uint64_t kJpegDecoderBytes = uint64_t{1} << 18;
constexpr uint64_t kJpegBytesPerColumn = 512;  // rows of blocks, before and after they are enlarged

/// The state of one decoding. libjpeg leaves by longjmp, so no frame between has a destructor.
struct JpegDecoding {
  jpeg_decompress_struct jpeg = {};
  jpeg_error_mgr errors = {};
  jpeg_progress_mgr progress = {};
  std::jmp_buf failed;
  char message[JMSG_LENGTH_MAX] = "";
  bool is_cut = false;
  const PictureTaker* taker = nullptr;
  bool is_cancelled = false;
};

JpegDecoding& decoding_of(j_common_ptr jpeg) {
  return *static_cast<JpegDecoding*>(jpeg->client_data);
}

[[noreturn]] void leave(j_common_ptr jpeg) {
  JpegDecoding& decoding = decoding_of(jpeg);
  jpeg->err->format_message(jpeg, decoding.message);
  std::longjmp(decoding.failed, 1);
}

void take_warning(j_common_ptr jpeg, int) {
  if (jpeg->err->msg_code == JWRN_JPEG_EOF) decoding_of(jpeg).is_cut = true;
}

bool goes_on(JpegDecoding& decoding) {
  decoding.is_cancelled = decoding.taker->goes_on && !decoding.taker->goes_on();
  return !decoding.is_cancelled;
}

/// libjpeg calls this between two rows of blocks.
void check_scans(j_common_ptr jpeg) {
  JpegDecoding& decoding = decoding_of(jpeg);
  if (!goes_on(decoding)) std::longjmp(decoding.failed, 1);
  if (decoding.jpeg.input_scan_number <= kScansMax) return;
  std::snprintf(decoding.message, sizeof decoding.message,
                "picture with more than %d scans, which is the limit", kScansMax);
  std::longjmp(decoding.failed, 1);
}

/// Each step returns false where libjpeg failed; `message` then says why.
bool read_header(JpegDecoding& decoding, std::span<const uint8_t> bytes) {
  if (setjmp(decoding.failed) != 0) return false;
  jpeg_create_decompress(&decoding.jpeg);
  decoding.jpeg.progress = &decoding.progress;
  jpeg_mem_src(&decoding.jpeg, bytes.data(), static_cast<unsigned long>(bytes.size()));
  jpeg_read_header(&decoding.jpeg, TRUE);
  return true;
}

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
  uint64_t bytes = kJpegDecoderBytes + jpeg.image_width * kJpegBytesPerColumn;
  if (!jpeg_has_multiple_scans(&jpeg)) return bytes;
  for (int c = 0; c < jpeg.num_components; ++c) {
    const jpeg_component_info& component = jpeg.comp_info[c];
    const uint64_t columns = uint64_t{component.width_in_blocks} + component.h_samp_factor;
    const uint64_t rows = uint64_t{component.height_in_blocks} + component.v_samp_factor;
    bytes += columns * rows * sizeof(JBLOCK);
  }
  return bytes;
}

/// Frees libjpeg's memory.
class JpegCleaner {
 public:
  explicit JpegCleaner(jpeg_decompress_struct& jpeg) : jpeg_(jpeg) {}
  ~JpegCleaner() { jpeg_destroy_decompress(&jpeg_); }

 private:
  jpeg_decompress_struct& jpeg_;
};

void prepare_decoding(JpegDecoding& decoding, const PictureTaker& taker) {
  decoding.taker = &taker;
  decoding.jpeg.err = jpeg_std_error(&decoding.errors);
  decoding.errors.error_exit = leave;
  decoding.errors.emit_message = take_warning;
  decoding.progress.progress_monitor = check_scans;
  decoding.jpeg.client_data = &decoding;
}

Status jpeg_failure(const JpegDecoding& decoding) {
  if (decoding.is_cancelled) return cancelled("decoding was cancelled");
  return invalid_argument(std::string("libjpeg: ") + decoding.message);
}

}  // namespace

Status read_jpeg_rows(std::span<const uint8_t> bytes, const PictureTaker& taker) {
  JpegDecoding decoding;
  prepare_decoding(decoding, taker);
  const JpegCleaner cleaner(decoding.jpeg);
  if (!read_header(decoding, bytes)) return jpeg_failure(decoding);
  auto& jpeg = decoding.jpeg;
  if (jpeg.num_components != 1 && jpeg.num_components != 3)
    return unimplemented("the JPEG has " + std::to_string(jpeg.num_components) +
                         " colour channels; only 1 and 3 are read");
  const PictureSize size{jpeg.image_width, jpeg.image_height, decoding_bytes_of(jpeg)};
  RETURN_IF_ERROR(begin_picture(size, bytes.size(), taker));
  std::vector<Rgba8> row(size.width);
  if (!begin_rows(decoding)) return jpeg_failure(decoding);
  for (uint32_t y = 0; y < size.height; ++y) {
    if (!read_row(decoding, row.data())) return jpeg_failure(decoding);
    taker.take({y, 0, 1, row});
  }
  if (!end_rows(decoding)) return jpeg_failure(decoding);
  if (decoding.is_cut) return invalid_argument("the JPEG ends before its last row");
  return Status::ok();
}

}  // namespace burnish
