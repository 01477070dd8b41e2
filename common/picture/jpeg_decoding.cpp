#include "common/picture/jpeg_decoding.h"

#include <jerror.h>
#include <string>

namespace burnish {

static constexpr int kScansMax = 100;
static constexpr uint64_t kJpegDecoderBytes = uint64_t{1} << 18;
static constexpr uint64_t kJpegBytesPerColumn = 512;  // rows of blocks, before and after they grow

static JpegDecoding& decoding_of(j_common_ptr jpeg) {
  return *static_cast<JpegDecoding*>(jpeg->client_data);
}

[[noreturn]] static void leave_jpeg(j_common_ptr jpeg) {
  JpegDecoding& decoding = decoding_of(jpeg);
  jpeg->err->format_message(jpeg, decoding.message);
  std::longjmp(decoding.failed, 1);
}

static void take_warning(j_common_ptr jpeg, int) {
  if (jpeg->err->msg_code == JWRN_JPEG_EOF) decoding_of(jpeg).is_cut = true;
}

/// libjpeg calls this between two rows of blocks.
static void check_decoding(j_common_ptr jpeg) {
  decoding_of(jpeg).check();
}

JpegDecoding::JpegDecoding(const PictureTaker& hears) : taker(hears) {
  jpeg.err = jpeg_std_error(&errors);
  errors.error_exit = leave_jpeg;
  errors.emit_message = take_warning;
  progress.progress_monitor = check_decoding;
  jpeg.client_data = this;
}

void JpegDecoding::check() {
  is_cancelled = taker.goes_on && !taker.goes_on();
  if (is_cancelled) std::longjmp(failed, 1);
  if (jpeg.input_scan_number <= kScansMax) return;
  std::snprintf(message, sizeof message, "picture with more than %d scans, which is the limit",
                kScansMax);
  std::longjmp(failed, 1);
}

Status JpegDecoding::failure() const {
  if (is_cancelled) return cancelled("decoding was cancelled");
  return invalid_argument(std::string("libjpeg: ") + message);
}

bool read_jpeg_header(JpegDecoding& decoding, std::span<const uint8_t> bytes, bool keeps_markers) {
  if (setjmp(decoding.failed) != 0) return false;
  jpeg_create_decompress(&decoding.jpeg);
  decoding.jpeg.progress = &decoding.progress;
  constexpr unsigned kWholeMarker = 0xffff;
  for (int kind = 0; keeps_markers && kind < 16; ++kind)
    jpeg_save_markers(&decoding.jpeg, JPEG_APP0 + kind, kWholeMarker);
  if (keeps_markers) jpeg_save_markers(&decoding.jpeg, JPEG_COM, kWholeMarker);
  jpeg_mem_src(&decoding.jpeg, bytes.data(), static_cast<unsigned long>(bytes.size()));
  jpeg_read_header(&decoding.jpeg, TRUE);
  return true;
}

uint64_t jpeg_coefficient_bytes(const jpeg_decompress_struct& jpeg) {
  uint64_t bytes = 0;
  for (int c = 0; c < jpeg.num_components; ++c) {
    const jpeg_component_info& component = jpeg.comp_info[c];
    const uint64_t columns = uint64_t{component.width_in_blocks} + component.h_samp_factor;
    const uint64_t rows = uint64_t{component.height_in_blocks} + component.v_samp_factor;
    bytes += columns * rows * sizeof(JBLOCK);
  }
  return bytes;
}

uint64_t jpeg_row_bytes(const jpeg_decompress_struct& jpeg) {
  return kJpegDecoderBytes + jpeg.image_width * kJpegBytesPerColumn;
}

}  // namespace burnish
