#include "common/picture/webp_decoding.h"

#include <algorithm>
#include <memory>

namespace burnish {

namespace {

constexpr uint64_t kPixelBytes = sizeof(Rgba8);
constexpr uint64_t kDecoderBytes = uint64_t{1} << 20;
constexpr uint64_t kBytesPerColumn = 256;       // rows of macroblocks and their filters
constexpr size_t kPartBytes = size_t{1} << 16;  // decoded between two questions
constexpr int kLossless = 2;                    // of a file's `format`

struct DeleteDecoder {
  void operator()(WebPIDecoder* decoder) const { WebPIDelete(decoder); }
};

Status failure_of(VP8StatusCode code) {
  if (code == VP8_STATUS_OUT_OF_MEMORY)
    return resource_exhausted("not enough memory for its pixels");
  if (code == VP8_STATUS_SUSPENDED) return invalid_argument("the WebP ends before its last row");
  return invalid_argument("the WebP is damaged: libwebp fails with code " + std::to_string(code));
}

}  // namespace

Result<WebPBitstreamFeatures> read_webp_features(std::span<const uint8_t> bytes) {
  WebPBitstreamFeatures features;
  const VP8StatusCode code = WebPGetFeatures(bytes.data(), bytes.size(), &features);
  if (code == VP8_STATUS_NOT_ENOUGH_DATA) return invalid_argument("the WebP ends in its header");
  if (code != VP8_STATUS_OK) return failure_of(code);
  if (features.has_animation != 0) return unimplemented("the WebP is animated");
  return features;
}

uint64_t webp_decoding_bytes(const WebPBitstreamFeatures& features) {
  const uint64_t pixels = uint64_t(features.width) * uint64_t(features.height);
  // A second copy in libwebp, or transparency, which is packed without loss.
  const bool has_copy = features.format == kLossless || features.has_alpha != 0;
  return kDecoderBytes + uint64_t(features.width) * kBytesPerColumn +
         pixels * kPixelBytes * (has_copy ? 2 : 1);
}

Status decode_webp_pixels(std::span<const uint8_t> bytes, const WebPBitstreamFeatures& features,
                          const std::function<bool()>& goes_on, std::span<Rgba8> pixels) {
  const std::unique_ptr<WebPIDecoder, DeleteDecoder> decoder(
      WebPINewRGB(MODE_RGBA, pixels[0].data(), pixels.size_bytes(),
                  features.width * static_cast<int>(kPixelBytes)));
  if (!decoder) return resource_exhausted("not enough memory for libwebp");
  VP8StatusCode code = VP8_STATUS_SUSPENDED;
  for (size_t known = 0; known < bytes.size() && code == VP8_STATUS_SUSPENDED;) {
    if (goes_on && !goes_on()) return cancelled("decoding was cancelled");
    known = std::min(known + kPartBytes, bytes.size());
    code = WebPIUpdate(decoder.get(), bytes.data(), known);
  }
  return code == VP8_STATUS_OK ? Status::ok() : failure_of(code);
}

}  // namespace burnish
