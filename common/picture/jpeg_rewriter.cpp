#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "common/picture/block_change.h"
#include "common/picture/jpeg_decoding.h"
#include "common/picture/picture_formats.h"
#include "common/picture/rewriters.h"

namespace burnish {

namespace {

using Weights = std::array<float, 3>;  // of red, green and blue

/// Returns how a component depends on colours. Source: ITU-T T.871, 7.
Weights weights_of(J_COLOR_SPACE space, int component) {
  static constexpr std::array<Weights, 3> kYCbCr = {
      {{0.299F, 0.587F, 0.114F}, {-0.168736F, -0.331264F, 0.5F}, {0.5F, -0.418688F, -0.081312F}}};
  if (space != JCS_RGB) return kYCbCr[static_cast<size_t>(component)];
  Weights alone = {0, 0, 0};
  alone[static_cast<size_t>(component)] = 1;
  return alone;
}

/// A file that is decoded, and its copy.
struct JpegRewriting : JpegDecoding {
  explicit JpegRewriting(const PictureTaker& hears) : JpegDecoding(hears) {}
  ~JpegRewriting() {
    jpeg_destroy_compress(&copy);
    std::free(bytes);
  }

  jpeg_compress_struct copy = {};
  jvirt_barray_ptr* coefficients = nullptr;
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  uint32_t band_rows = 0;
};

/// Reads all coefficients, and begins to make pixels of them.
bool begin_output(JpegRewriting& work) {
  if (setjmp(work.failed) != 0) return false;
  work.jpeg.buffered_image = TRUE;
  work.jpeg.out_color_space = JCS_RGB;
  work.jpeg.do_block_smoothing = FALSE;  // it looks at blocks that have changed
  jpeg_start_decompress(&work.jpeg);
  for (int state = 0; state != JPEG_REACHED_EOI;) {
    state = jpeg_consume_input(&work.jpeg);
    work.check();
  }
  work.coefficients = jpeg_read_coefficients(&work.jpeg);
  jpeg_start_output(&work.jpeg, work.jpeg.input_scan_number);
  return true;
}

bool read_band(JpegRewriting& work, uint8_t* pixels, uint32_t rows) {
  if (setjmp(work.failed) != 0) return false;
  for (uint32_t y = 0; y < rows; ++y) {
    JSAMPROW row = pixels + size_t{3} * y * work.jpeg.image_width;
    if (jpeg_read_scanlines(&work.jpeg, &row, 1) != 1) return false;
    work.check();
  }
  return true;
}

/// Returns a row of blocks. Null: libjpeg failed.
JBLOCKROW row_of_blocks(JpegRewriting& work, int component, uint32_t row) {
  if (setjmp(work.failed) != 0) return nullptr;
  auto* common = reinterpret_cast<j_common_ptr>(&work.jpeg);
  return work.jpeg.mem->access_virt_barray(common, work.coefficients[component], row, 1, TRUE)[0];
}

/// The header's own markers are written by libjpeg.
bool is_written_anyway(const JpegRewriting& work, const jpeg_marker_struct& marker) {
  const auto begins = [&](std::string_view mark) {
    return marker.data_length >= mark.size() && std::equal(mark.begin(), mark.end(), marker.data);
  };
  return (work.copy.write_JFIF_header && marker.marker == JPEG_APP0 &&
          begins(std::string_view("JFIF\0", 5))) ||
         (work.copy.write_Adobe_marker && marker.marker == JPEG_APP0 + 14 && begins("Adobe"));
}

bool write_copy(JpegRewriting& work) {
  if (setjmp(work.failed) != 0) return false;
  work.copy.err = &work.errors;
  work.copy.client_data = static_cast<JpegDecoding*>(&work);
  jpeg_create_compress(&work.copy);
  work.copy.progress = &work.progress;
  jpeg_mem_dest(&work.copy, &work.bytes, &work.size);
  jpeg_copy_critical_parameters(&work.jpeg, &work.copy);
  work.copy.write_JFIF_header = work.jpeg.saw_JFIF_marker;
  work.copy.write_Adobe_marker = work.jpeg.saw_Adobe_marker;
  work.copy.restart_interval = work.jpeg.restart_interval;
  work.copy.optimize_coding = TRUE;
  if (work.jpeg.progressive_mode) jpeg_simple_progression(&work.copy);
  jpeg_write_coefficients(&work.copy, work.coefficients);
  for (const auto* marker = work.jpeg.marker_list; marker != nullptr; marker = marker->next)
    if (!is_written_anyway(work, *marker))
      jpeg_write_marker(&work.copy, marker->marker, marker->data, marker->data_length);
  jpeg_finish_compress(&work.copy);
  return true;
}

Status check_kind(const jpeg_decompress_struct& jpeg) {
  if (jpeg.num_components != 1 && jpeg.num_components != 3)
    return unimplemented("a JPEG of " + std::to_string(jpeg.num_components) +
                         " colour channels (CMYK has 4); only 1 and 3 are written");
  if (jpeg.arith_code) return unimplemented("a JPEG with arithmetic coding");
  for (const J_COLOR_SPACE known : {JCS_GRAYSCALE, JCS_YCbCr, JCS_RGB})
    if (jpeg.jpeg_color_space == known) return Status::ok();
  return unimplemented("a JPEG of another colour space than grey, YCbCr and RGB");
}

/// The colours of a band before and after a change.
class JpegBand {
 public:
  JpegBand(uint32_t width, uint32_t rows)
      : width_(width), before_(size_t{3} * width * rows), after_(size_t{width} * rows) {}

  static uint64_t bytes_of(uint32_t width, uint32_t rows) {
    return uint64_t{width} * rows * (3 + sizeof(FileTexel));
  }

  uint8_t* pixels() { return before_.data(); }
  std::span<FileTexel> texels(uint32_t rows) {
    return std::span(after_).first(size_t{width_} * rows);
  }

  void begin(uint32_t rows) {
    rows_ = rows;
    for (size_t t = 0; t < size_t{width_} * rows; ++t)
      for (size_t i = 0; i < 3; ++i) after_[t][i] = before_[3 * t + i];
  }

  uint64_t count_changed() const {
    uint64_t count = 0;
    for (size_t t = 0; t < size_t{width_} * rows_; ++t) count += is_changed(t) ? 1 : 0;
    return count;
  }

  /// Returns the change of a block's samples, of which each is the mean of some pixels. Returns
  /// false if nothing changed. Pixels beyond the border change as the last ones do.
  bool change_of(const Weights& weights, uint32_t left, uint32_t top, uint32_t across,
                 uint32_t down, Block8& samples) const {
    if (!is_any_changed(left, top, 8 * across, 8 * down)) return false;
    samples.fill(0);
    const float share = 1.F / static_cast<float>(across * down);
    for (uint32_t y = 0; y < 8 * down; ++y)
      for (uint32_t x = 0; x < 8 * across; ++x)
        samples[8 * (y / down) + x / across] += share * change_at(weights, left + x, top + y);
    return true;
  }

 private:
  bool is_changed(size_t texel) const {
    return after_[texel][0] != before_[3 * texel] || after_[texel][1] != before_[3 * texel + 1] ||
           after_[texel][2] != before_[3 * texel + 2];
  }

  bool is_any_changed(uint32_t left, uint32_t top, uint32_t width, uint32_t height) const {
    for (uint32_t y = top; y < std::min(top + height, rows_); ++y)
      for (uint32_t x = left; x < std::min(left + width, width_); ++x)
        if (is_changed(size_t{y} * width_ + x)) return true;
    return false;
  }

  float change_at(const Weights& weights, uint32_t x, uint32_t y) const {
    const size_t t = size_t{std::min(y, rows_ - 1)} * width_ + std::min(x, width_ - 1);
    float change = 0;
    for (size_t i = 0; i < 3; ++i)
      change += weights[i] * static_cast<float>(after_[t][i] - int{before_[3 * t + i]});
    return change;
  }

  uint32_t width_, rows_ = 0;
  std::vector<uint8_t> before_;
  std::vector<FileTexel> after_;
};

/// Adds a band's change to the blocks that it touches. Returns false where libjpeg failed.
bool add_to_blocks(JpegRewriting& work, const JpegBand& band, uint32_t first_row, uint32_t rows) {
  const auto& jpeg = work.jpeg;
  for (int c = 0; c < jpeg.num_components; ++c) {
    const jpeg_component_info& component = jpeg.comp_info[c];
    const auto across = static_cast<uint32_t>(jpeg.max_h_samp_factor / component.h_samp_factor);
    const auto down = static_cast<uint32_t>(jpeg.max_v_samp_factor / component.v_samp_factor);
    const Weights weights = weights_of(jpeg.jpeg_color_space, c);
    const std::span<const uint16_t, 64> steps(component.quant_table->quantval);
    for (uint32_t top = 0; top < rows; top += 8 * down) {
      const JBLOCKROW blocks = row_of_blocks(work, c, (first_row + top) / (8 * down));
      if (blocks == nullptr) return false;
      const auto columns = static_cast<int>(component.width_in_blocks);
#pragma omp parallel for schedule(static)
      for (int b = 0; b < columns; ++b) {
        Block8 samples;
        const uint32_t left = static_cast<uint32_t>(b) * 8 * across;
        if (band.change_of(weights, left, top, across, down, samples))
          add_to_block(samples, steps, std::span<int16_t, 64>(blocks[b]));
      }
    }
  }
  return true;
}

/// Changes all bands. Returns how many pixels differ.
Result<uint64_t> edit_bands(JpegRewriting& work, const PictureEditor& editor) {
  const uint32_t width = work.jpeg.image_width, height = work.jpeg.image_height;
  JpegBand band(width, work.band_rows);
  uint64_t changed = 0;
  for (uint32_t first = 0; first < height; first += work.band_rows) {
    const uint32_t rows = std::min(work.band_rows, height - first);
    if (!read_band(work, band.pixels(), rows)) return work.failure();
    band.begin(rows);
    RETURN_IF_ERROR(editor.change({first, rows, width, 255, band.texels(rows)}));
    const uint64_t count = band.count_changed();
    changed += count;
    if (count > 0 && !add_to_blocks(work, band, first, rows)) return work.failure();
  }
  return changed;
}

PictureSize size_of(const JpegRewriting& work, uint64_t file_bytes) {
  constexpr uint64_t kCopies = 4;  // a buffer that grows by doubling, markers, what is returned
  const auto& jpeg = work.jpeg;
  return {jpeg.image_width, jpeg.image_height,
          jpeg_row_bytes(jpeg) + jpeg_coefficient_bytes(jpeg) + kCopies * file_bytes +
              JpegBand::bytes_of(jpeg.image_width, work.band_rows)};
}

}  // namespace

Result<RewrittenPicture> rewrite_jpeg(std::span<const uint8_t> bytes, const PictureEditor& editor) {
  const PictureTaker taker{editor.begin, {}, editor.goes_on};
  JpegRewriting work(taker);
  if (!read_jpeg_header(work, bytes, true)) return work.failure();
  RETURN_IF_ERROR(check_kind(work.jpeg));
  const auto mcu_rows = static_cast<uint32_t>(8 * work.jpeg.max_v_samp_factor);
  work.band_rows = (kEditedRows + mcu_rows - 1) / mcu_rows * mcu_rows;
  RETURN_IF_ERROR(begin_picture(size_of(work, bytes.size()), bytes.size(), taker));
  if (!begin_output(work)) return work.failure();
  if (work.is_cut) return invalid_argument("the JPEG ends before its last row");
  RewrittenPicture rewritten;
  ASSIGN_OR_RETURN(rewritten.texels, edit_bands(work, editor));
  if (rewritten.texels == 0) return rewritten;
  const std::span<const uint8_t> behind(work.jpeg.src->next_input_byte,
                                        work.jpeg.src->bytes_in_buffer);
  if (!write_copy(work)) return work.failure();
  rewritten.bytes.assign(work.bytes, work.bytes + work.size);
  rewritten.bytes.insert(rewritten.bytes.end(), behind.begin(), behind.end());
  return rewritten;
}

}  // namespace burnish
