#include "common/sheets/webp_texels.h"

#include <algorithm>
#include <string>

#include <webp/decode.h>
#include <webp/encode.h>

#include "common/base/check.h"

namespace burnish {

namespace {

/// A picture and a writer of libwebp, which are freed in any case.
struct WebpEncoding {
  WebpEncoding() {
    BURNISH_CHECK(WebPPictureInit(&picture) != 0, "libwebp has another version than its headers");
    WebPMemoryWriterInit(&writer);
    picture.writer = WebPMemoryWrite;
    picture.custom_ptr = &writer;
  }
  WebpEncoding(const WebpEncoding&) = delete;
  ~WebpEncoding() {
    WebPPictureFree(&picture);
    WebPMemoryWriterClear(&writer);
  }

  WebPPicture picture;
  WebPMemoryWriter writer;
};

WebPConfig webp_config(SheetCodec codec) {
  WebPConfig config;
  BURNISH_CHECK(WebPConfigPreset(&config, WEBP_PRESET_DEFAULT, kSheetQuality) != 0,
                "libwebp has another version than its headers");
  config.exact = 1;
  config.lossless = codec == SheetCodec::kLosslessWebp ? 1 : 0;
  return config;
}

}  // namespace

Result<std::vector<uint8_t>> encode_webp(std::span<const Rgba8> texels, uint32_t width,
                                         uint32_t height, SheetCodec codec) {
  WebpEncoding encoding;
  WebPPicture& picture = encoding.picture;
  picture.width = static_cast<int>(width);
  picture.height = static_cast<int>(height);
  picture.use_argb = codec == SheetCodec::kLosslessWebp ? 1 : 0;
  const bool has_alpha =
      std::ranges::any_of(texels, [](const Rgba8& texel) { return texel[3] < 255; });
  const auto import = has_alpha ? WebPPictureImportRGBA : WebPPictureImportRGBX;
  const int row_bytes = static_cast<int>(width * sizeof(Rgba8));
  const WebPConfig config = webp_config(codec);
  if (import(&picture, texels[0].data(), row_bytes) == 0 || WebPEncode(&config, &picture) == 0)
    return resource_exhausted("a WebP of " + std::to_string(width) + "x" + std::to_string(height) +
                              " texels: libwebp fails with code " +
                              std::to_string(picture.error_code));
  return std::vector<uint8_t>(encoding.writer.mem, encoding.writer.mem + encoding.writer.size);
}

Result<std::vector<Rgba8>> decode_webp(std::span<const uint8_t> bytes, uint32_t width,
                                       uint32_t height, SheetCodec codec) {
  RETURN_IF_ERROR(check_webp(bytes, width, height, codec));
  std::vector<Rgba8> texels(size_t{width} * height);
  const int row_bytes = static_cast<int>(width * sizeof(Rgba8));
  if (WebPDecodeRGBAInto(bytes.data(), bytes.size(), texels[0].data(),
                         texels.size() * sizeof(Rgba8), row_bytes) == nullptr)
    return data_loss("the WebP does not decode");
  return texels;
}

}  // namespace burnish
