#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include <webp/encode.h>

#include "common/base/check.h"
#include "common/picture/picture_formats.h"
#include "common/picture/rewriters.h"
#include "common/picture/webp_decoding.h"

namespace burnish {

namespace {

// At a higher level the file is 2 % smaller and takes twice as long.
constexpr int kLosslessLevel = 1;
constexpr uint64_t kRewritingBytesPerPixel = 40;  // 34 were measured, the pixels with them

struct WebpWriting {
  explicit WebpWriting(const PictureEditor& editor) : hears(editor) {
    BURNISH_CHECK(WebPPictureInit(&picture) != 0 && WebPConfigInit(&config) != 0 &&
                      WebPConfigLosslessPreset(&config, kLosslessLevel) != 0,
                  "libwebp has another version than its headers");
    config.exact = 1;  // the colours of transparent pixels count too
    WebPMemoryWriterInit(&writer);
    picture.writer = WebPMemoryWrite;
    picture.custom_ptr = &writer;
    picture.use_argb = 1;
    picture.user_data = this;
    picture.progress_hook = [](int, const WebPPicture* of) {
      const PictureEditor& heard = static_cast<const WebpWriting*>(of->user_data)->hears;
      return !heard.goes_on || heard.goes_on() ? 1 : 0;
    };
  }
  WebpWriting(const WebpWriting&) = delete;
  ~WebpWriting() {
    WebPPictureFree(&picture);
    WebPMemoryWriterClear(&writer);
  }

  const PictureEditor& hears;
  WebPConfig config;
  WebPPicture picture;
  WebPMemoryWriter writer;
};

Result<std::vector<uint8_t>> encode(std::span<const Rgba8> pixels, int width, int height,
                                    const PictureEditor& editor) {
  WebpWriting writing(editor);
  WebPPicture& picture = writing.picture;
  picture.width = width;
  picture.height = height;
  const int row_bytes = width * static_cast<int>(sizeof(Rgba8));
  if (WebPPictureImportRGBA(&picture, pixels[0].data(), row_bytes) != 0 &&
      WebPEncode(&writing.config, &picture) != 0)
    return std::vector<uint8_t>(writing.writer.mem, writing.writer.mem + writing.writer.size);
  if (picture.error_code == VP8_ENC_ERROR_USER_ABORT) return cancelled("rewriting was cancelled");
  return resource_exhausted("libwebp cannot write its pixels: code " +
                            std::to_string(picture.error_code));
}

/// Returns how many pixels of a band get another colour. Transparency stays.
uint64_t take_changes(std::span<const FileTexel> texels, std::span<Rgba8> pixels) {
  uint64_t changed = 0;
  for (size_t t = 0; t < texels.size(); ++t) {
    const Rgba8 before = pixels[t];
    for (size_t i = 0; i < 3; ++i) pixels[t][i] = static_cast<uint8_t>(texels[t][i]);
    changed += pixels[t] != before ? 1 : 0;
  }
  return changed;
}

Result<uint64_t> change_pixels(const PictureEditor& editor, uint32_t width,
                               std::span<Rgba8> pixels) {
  uint64_t changed = 0;
  std::vector<FileTexel> texels;
  const auto height = static_cast<uint32_t>(pixels.size() / width);
  for (uint32_t y = 0; y < height; y += kEditedRows) {
    if (editor.goes_on && !editor.goes_on()) return cancelled("rewriting was cancelled");
    const uint32_t rows = std::min(kEditedRows, height - y);
    const std::span<Rgba8> band = pixels.subspan(size_t{y} * width, size_t{rows} * width);
    texels.resize(band.size());
    std::ranges::transform(band, texels.begin(), [](const Rgba8& pixel) {
      return FileTexel{pixel[0], pixel[1], pixel[2]};
    });
    RETURN_IF_ERROR(editor.change({y, rows, width, 255, texels}));
    changed += take_changes(texels, band);
  }
  return changed;
}

/// Returns whether the file has a colour profile, whose chunk follows that of the sizes.
bool has_profile(std::span<const uint8_t> bytes) {
  constexpr size_t kFlags = 20;
  constexpr uint8_t kProfile = 0x20;
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return text.size() > kFlags && text.substr(12, 4) == "VP8X" && (bytes[kFlags] & kProfile) != 0;
}

}  // namespace

Result<RewrittenPicture> rewrite_webp(std::span<const uint8_t> bytes, const PictureEditor& editor) {
  ASSIGN_OR_RETURN(const WebPBitstreamFeatures features, read_webp_features(bytes));
  if (has_profile(bytes)) return unimplemented("a WebP with a colour profile");
  const auto width = static_cast<uint32_t>(features.width);
  const auto height = static_cast<uint32_t>(features.height);
  const uint64_t pixel_count = uint64_t{width} * height;
  RETURN_IF_ERROR(begin_picture({width, height, pixel_count * kRewritingBytesPerPixel},
                                bytes.size(), {editor.begin, {}, editor.goes_on}));
  std::vector<Rgba8> pixels(pixel_count);
  RETURN_IF_ERROR(decode_webp_pixels(bytes, features, editor.goes_on, pixels));
  RewrittenPicture rewritten;
  ASSIGN_OR_RETURN(rewritten.texels, change_pixels(editor, width, pixels));
  if (rewritten.texels == 0) return rewritten;
  ASSIGN_OR_RETURN(rewritten.bytes, encode(pixels, features.width, features.height, editor));
  rewritten.note = "it is packed without loss now";
  return rewritten;
}

}  // namespace burnish
