#include "common/frame_codec/body_compression.h"

#include <memory>
#include <zstd.h>

namespace burnish {

static constexpr int kZstdLevel = 1;  // level 3 is slower but not smaller: residuals do not repeat

// A context takes a megabyte, so each thread keeps one, not each client.
static ZSTD_CCtx* compression_context() {
  thread_local const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(),
                                                                                  &ZSTD_freeCCtx);
  return context.get();
}

static ZSTD_DCtx* decompression_context() {
  thread_local const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(ZSTD_createDCtx(),
                                                                                  &ZSTD_freeDCtx);
  return context.get();
}

void append_compressed(std::span<const uint8_t> body, std::vector<uint8_t>& bytes) {
  const size_t begin = bytes.size();
  bytes.resize(begin + ZSTD_compressBound(body.size()));
  const size_t written =
      ZSTD_compressCCtx(compression_context(), bytes.data() + begin, bytes.size() - begin,
                        body.data(), body.size(), kZstdLevel);
  BURNISH_CHECK(!ZSTD_isError(written), ZSTD_getErrorName(written));
  bytes.resize(begin + written);
}

Result<std::vector<uint8_t>> decompress(std::span<const uint8_t> bytes, size_t size) {
  std::vector<uint8_t> body(size);
  const size_t read = ZSTD_decompressDCtx(decompression_context(), body.data(), body.size(),
                                          bytes.data(), bytes.size());
  if (ZSTD_isError(read))
    return data_loss(std::string("the body does not decompress: ") + ZSTD_getErrorName(read));
  if (read != size)
    return data_loss("the body decompresses to " + std::to_string(read) +
                     " bytes, the header says " + std::to_string(size));
  return body;
}

}  // namespace burnish
