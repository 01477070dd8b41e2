#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/picture/picture_formats.h"
#include "common/picture/png_reading.h"
#include "common/picture/rewriters.h"

namespace burnish {

namespace {

constexpr uint64_t kPngCodecBytes = uint64_t{1} << 20;  // zlib's windows and libpng's buffers

/// A chunk of a PNG file.
struct PngChunk {
  std::string_view kind;  ///< four letters
  std::span<const uint8_t> data;
  bool is_behind_pixels = false;
};

constexpr size_t kSignatureBytes = 8, kWordBytes = 4;
constexpr size_t kFrameBytes = 3 * kWordBytes;  // length, kind and sum

size_t word_at(std::span<const uint8_t> bytes) {
  return size_t{bytes[0]} << 24 | size_t{bytes[1]} << 16 | size_t{bytes[2]} << 8 | bytes[3];
}

/// Lists the chunks of a PNG file in their order, without the header, the pixels and the end. Ends
/// where the file does not go on as one.
std::vector<PngChunk> list_png_chunks(std::span<const uint8_t> bytes) {
  std::vector<PngChunk> chunks;
  bool is_behind_pixels = false;
  for (size_t at = kSignatureBytes; at < bytes.size() && bytes.size() - at >= kFrameBytes;) {
    const size_t size = word_at(bytes.subspan(at));
    if (size > bytes.size() - at - kFrameBytes) break;
    const auto kind = bytes.subspan(at + kWordBytes, kWordBytes);
    const std::string_view name(reinterpret_cast<const char*>(kind.data()), kind.size());
    if (name == "IEND") break;
    if (name == "IDAT") is_behind_pixels = true;
    if (name != "IDAT" && name != "IHDR")
      chunks.push_back({name, bytes.subspan(at + 2 * kWordBytes, size), is_behind_pixels});
    at += kFrameBytes + size;
  }
  return chunks;
}

/// The rows of a picture, as they are written.
struct PngLayout {
  uint32_t width = 0, height = 0;
  size_t row_bytes = 0;
  int depth = 8, channels = 3, colour_type = PNG_COLOR_TYPE_RGB;
  bool is_expanded = false;          // a palette, or a grey of less than 8 bits
  std::optional<FileTexel> cut_out;  // this colour is transparent

  int colours() const { return channels < 3 ? 1 : 3; }
  size_t texel_bytes() const { return static_cast<size_t>(channels * depth / 8); }
  uint16_t max() const { return static_cast<uint16_t>((1u << depth) - 1); }
};

/// A file that is written to memory.
struct PngWriting {
  PngWriting();
  ~PngWriting() { png_destroy_write_struct(&png, &info); }
  PngWriting(const PngWriting&) = delete;
  PngWriting& operator=(const PngWriting&) = delete;

  Status failure() const {
    if (info == nullptr) return resource_exhausted("not enough memory for libpng");
    return is_full ? resource_exhausted("not enough memory for its new file")
                   : internal_error("libpng: " + message);
  }

  png_structp png = nullptr;
  png_infop info = nullptr;
  std::vector<uint8_t> bytes;
  std::string message;
  bool is_full = false;
};

[[noreturn]] void leave_writing(png_structp png, png_const_charp message) {
  static_cast<PngWriting*>(png_get_error_ptr(png))->message = message;
  png_longjmp(png, 1);
}

void ignore_complaint(png_structp, png_const_charp) {}
void flush_nothing(png_structp) {}

void take_bytes(png_structp png, png_bytep from, size_t count) {
  auto* writing = static_cast<PngWriting*>(png_get_io_ptr(png));
  try {
    writing->bytes.insert(writing->bytes.end(), from, from + count);
  } catch (const std::bad_alloc&) {
    writing->is_full = true;
  }
  if (writing->is_full) png_error(png, "no memory");
}

PngWriting::PngWriting() {
  png = png_create_write_struct(PNG_LIBPNG_VER_STRING, this, leave_writing, ignore_complaint);
  if (png == nullptr) return;
  info = png_create_info_struct(png);
  png_set_write_fn(png, this, take_bytes, flush_nothing);
}

/// A palette and small greys cannot hold a changed colour.
bool choose_layout(PngReading& reading, PngLayout& layout) {
  png_structp png = reading.png;
  png_infop info = reading.info;
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  layout.width = png_get_image_width(png, info);
  layout.height = png_get_image_height(png, info);
  layout.is_expanded =
      png_get_color_type(png, info) == PNG_COLOR_TYPE_PALETTE || png_get_bit_depth(png, info) < 8;
  if (layout.is_expanded) png_set_expand(png);
  png_color_16p key = nullptr;
  const bool has_key = png_get_tRNS(png, info, nullptr, nullptr, &key) != 0 && key != nullptr;
  if (has_key && !layout.is_expanded)
    layout.cut_out = png_get_channels(png, info) < 3 ? FileTexel{key->gray, key->gray, key->gray}
                                                     : FileTexel{key->red, key->green, key->blue};
  if (reading.is_interlaced()) png_set_interlace_handling(png);
  png_read_update_info(png, info);
  layout.row_bytes = png_get_rowbytes(png, info);
  layout.depth = png_get_bit_depth(png, info);
  layout.channels = png_get_channels(png, info);
  layout.colour_type = png_get_color_type(png, info);
  return true;
}

bool read_rows(PngReading& reading, const PngLayout& layout, uint8_t* rows, uint32_t count) {
  if (setjmp(png_jmpbuf(reading.png)) != 0) return false;
  for (uint32_t y = 0; y < count; ++y)
    png_read_row(reading.png, rows + y * layout.row_bytes, nullptr);
  return true;
}

bool write_header(PngWriting& writing, const PngLayout& layout) {
  if (writing.info == nullptr || setjmp(png_jmpbuf(writing.png)) != 0) return false;
  png_set_IHDR(writing.png, writing.info, layout.width, layout.height, layout.depth,
               layout.colour_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_write_info_before_PLTE(writing.png, writing.info);
  return true;
}

bool write_chunk(PngWriting& writing, const PngChunk& chunk) {
  if (setjmp(png_jmpbuf(writing.png)) != 0) return false;
  png_write_chunk(writing.png, reinterpret_cast<png_const_bytep>(chunk.kind.data()),
                  chunk.data.data(), chunk.data.size());
  return true;
}

bool write_rows(PngWriting& writing, const PngLayout& layout, const uint8_t* rows, uint32_t count) {
  if (setjmp(png_jmpbuf(writing.png)) != 0) return false;
  for (uint32_t y = 0; y < count; ++y) png_write_row(writing.png, rows + y * layout.row_bytes);
  return true;
}

bool write_end(PngWriting& writing) {
  if (setjmp(png_jmpbuf(writing.png)) != 0) return false;
  png_write_end(writing.png, nullptr);
  return true;
}

/// These speak of the colours as they were stored.
bool goes_with_expansion(const PngChunk& chunk) {
  constexpr std::array<std::string_view, 5> kOfColours = {"PLTE", "tRNS", "bKGD", "hIST", "sBIT"};
  return std::ranges::find(kOfColours, chunk.kind) != kOfColours.end();
}

/// libpng decodes all pictures to sRGB. Those of another gamma would have to be encoded back.
Status check_gamma(const PngReading& reading) {
  constexpr double kGammaOfSrgb = 1 / 2.2, kMeant = 0.05;  // libpng's own tolerance
  double gamma = 0;
  if (png_get_gAMA(reading.png, reading.info, &gamma) == 0) return Status::ok();
  if (std::abs(gamma / kGammaOfSrgb - 1) <= kMeant) return Status::ok();
  return unimplemented("a PNG of gamma " + std::to_string(gamma) + "; only sRGB is written");
}

class PngRewriter {
 public:
  PngRewriter(std::span<const uint8_t> bytes, const PictureEditor& editor)
      : bytes_(bytes), editor_(editor), reading_(bytes) {}

  Result<RewrittenPicture> rewrite() {
    if (!read_png_header(reading_)) return reading_.failure();
    RETURN_IF_ERROR(check_gamma(reading_));
    if (!choose_layout(reading_, layout_)) return reading_.failure();
    RETURN_IF_ERROR(begin_picture({layout_.width, layout_.height, bytes_taken()}, bytes_.size(),
                                  {editor_.begin, {}, editor_.goes_on}));
    RETURN_IF_ERROR(read_interlaced());
    if (!write_header(writing_, layout_)) return writing_.failure();
    const auto chunks = list_png_chunks(bytes_);
    RETURN_IF_ERROR(copy_chunks(chunks, false));
    RETURN_IF_ERROR(edit_rows());
    if (rewritten_.texels == 0) return rewritten_;
    RETURN_IF_ERROR(copy_chunks(chunks, true));
    if (!write_end(writing_)) return writing_.failure();
    rewritten_.bytes = std::move(writing_.bytes);
    if (layout_.is_expanded) rewritten_.note = "its pixels have 8 bits a channel now";
    if (reading_.is_interlaced()) rewritten_.note = "it is not interlaced any more";
    return std::move(rewritten_);
  }

 private:
  /// The new file may be as long as the pixels are.
  uint64_t bytes_taken() const {
    const uint64_t all = uint64_t{layout_.height} * layout_.row_bytes;
    const uint64_t band = kEditedRows * (2 * layout_.row_bytes + layout_.width * sizeof(FileTexel));
    return kPngCodecBytes + band + all + (reading_.is_interlaced() ? all : 0);
  }

  Status read_interlaced() {
    if (!reading_.is_interlaced()) return Status::ok();
    whole_.resize(layout_.height * layout_.row_bytes);
    for (int pass = 0; pass < PNG_INTERLACE_ADAM7_PASSES; ++pass)
      for (uint32_t y = 0; y < layout_.height; y += kEditedRows) {
        RETURN_IF_ERROR(heard());
        const uint32_t rows = std::min(kEditedRows, layout_.height - y);
        if (!read_rows(reading_, layout_, &whole_[y * layout_.row_bytes], rows))
          return reading_.failure();
      }
    return Status::ok();
  }

  Status heard() const {
    if (!editor_.goes_on || editor_.goes_on()) return Status::ok();
    return cancelled("rewriting was cancelled");
  }

  Status copy_chunks(std::span<const PngChunk> chunks, bool behind_pixels) {
    for (const PngChunk& chunk : chunks) {
      if (chunk.is_behind_pixels != behind_pixels) continue;
      if (layout_.is_expanded && goes_with_expansion(chunk)) continue;
      if (!write_chunk(writing_, chunk)) return writing_.failure();
    }
    return Status::ok();
  }

  Status edit_rows() {
    std::vector<uint8_t> band(kEditedRows * layout_.row_bytes);
    std::vector<FileTexel> texels(size_t{kEditedRows} * layout_.width);
    for (uint32_t first = 0; first < layout_.height; first += kEditedRows) {
      RETURN_IF_ERROR(heard());
      const uint32_t rows = std::min(kEditedRows, layout_.height - first);
      uint8_t* pixels = band.data();
      if (!whole_.empty()) pixels = &whole_[first * layout_.row_bytes];
      if (whole_.empty() && !read_rows(reading_, layout_, pixels, rows)) return reading_.failure();
      const auto edited = std::span(texels).first(size_t{rows} * layout_.width);
      for (size_t t = 0; t < edited.size(); ++t) edited[t] = read(pixel(pixels, t));
      RETURN_IF_ERROR(editor_.change({first, rows, layout_.width, layout_.max(), edited}));
      for (size_t t = 0; t < edited.size(); ++t) put(edited[t], pixel(pixels, t));
      if (!write_rows(writing_, layout_, pixels, rows)) return writing_.failure();
    }
    return Status::ok();
  }

  uint8_t* pixel(uint8_t* rows, size_t texel) const {
    return rows + texel / layout_.width * layout_.row_bytes +
           texel % layout_.width * layout_.texel_bytes();
  }

  FileTexel read(const uint8_t* pixel) const {
    FileTexel texel;
    for (size_t i = 0; i < 3; ++i) {
      const size_t channel = layout_.colours() == 1 ? 0 : i;
      texel[i] = layout_.depth == 8
                     ? pixel[channel]
                     : static_cast<uint16_t>(pixel[2 * channel] << 8 | pixel[2 * channel + 1]);
    }
    return texel;
  }

  /// A colour that is cut out stays so, and no other one becomes it.
  FileTexel kept(FileTexel wanted, const FileTexel& before) const {
    if (layout_.colours() == 1) wanted.fill(grey_of(wanted));
    if (!layout_.cut_out || wanted == before) return wanted;
    if (before == *layout_.cut_out) return before;
    const bool is_up = wanted[2] < before[2] || wanted[2] == 0;
    if (wanted != *layout_.cut_out) return wanted;
    wanted[2] = static_cast<uint16_t>(is_up ? wanted[2] + 1 : wanted[2] - 1);
    if (layout_.colours() == 1) wanted.fill(wanted[2]);
    return wanted;
  }

  void put(const FileTexel& wanted, uint8_t* pixel) {
    const FileTexel before = read(pixel), after = kept(wanted, before);
    if (after == before) return;
    ++rewritten_.texels;
    for (int i = 0; i < layout_.colours(); ++i) {
      const uint16_t value = after[static_cast<size_t>(i)];
      if (layout_.depth == 16) *pixel++ = static_cast<uint8_t>(value >> 8);
      *pixel++ = static_cast<uint8_t>(value);
    }
  }

  const std::span<const uint8_t> bytes_;
  const PictureEditor& editor_;
  PngReading reading_;
  PngWriting writing_;
  PngLayout layout_;
  std::vector<uint8_t> whole_;  // of an interlaced picture
  RewrittenPicture rewritten_;
};

}  // namespace

Result<RewrittenPicture> rewrite_png(std::span<const uint8_t> bytes, const PictureEditor& editor) {
  return PngRewriter(bytes, editor).rewrite();
}

}  // namespace burnish
