#include "common/packing/zstd_frame.h"

#include <memory>
#include <zstd.h>

namespace burnish {

namespace {

// A context takes a megabyte, so each thread keeps one, not each client.
ZSTD_CCtx* compression_context() {
  thread_local const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(),
                                                                                  &ZSTD_freeCCtx);
  return context.get();
}

ZSTD_DCtx* decompression_context() {
  thread_local const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(ZSTD_createDCtx(),
                                                                                  &ZSTD_freeDCtx);
  return context.get();
}

size_t checked(size_t result) {
  BURNISH_CHECK(!ZSTD_isError(result), ZSTD_getErrorName(result));
  return result;
}

}  // namespace

void append_compressed(std::span<const std::span<const uint8_t>> sections, int zstd_level,
                       std::vector<uint8_t>& bytes) {
  size_t size = 0;
  size_t room = 0;
  for (const auto& section : sections) {
    size += section.size();
    room += ZSTD_compressBound(section.size());
  }
  ZSTD_CCtx* const context = compression_context();
  checked(ZSTD_CCtx_reset(context, ZSTD_reset_session_and_parameters));
  checked(ZSTD_CCtx_setParameter(context, ZSTD_c_compressionLevel, zstd_level));
  checked(ZSTD_CCtx_setPledgedSrcSize(context, size));
  const size_t begin = bytes.size();
  bytes.resize(begin + ZSTD_compressBound(0) + room);
  ZSTD_outBuffer output{bytes.data() + begin, bytes.size() - begin, 0};
  for (const auto& section : sections) {
    ZSTD_inBuffer input{section.data(), section.size(), 0};
    checked(ZSTD_compressStream2(context, &output, &input, ZSTD_e_flush));
  }
  ZSTD_inBuffer none{nullptr, 0, 0};
  BURNISH_CHECK(checked(ZSTD_compressStream2(context, &output, &none, ZSTD_e_end)) == 0,
                "the room for a zstd frame is too small");
  bytes.resize(begin + output.pos);
}

void append_compressed(std::span<const uint8_t> body, int zstd_level, std::vector<uint8_t>& bytes) {
  const size_t begin = bytes.size();
  bytes.resize(begin + ZSTD_compressBound(body.size()));
  const size_t written =
      checked(ZSTD_compressCCtx(compression_context(), bytes.data() + begin, bytes.size() - begin,
                                body.data(), body.size(), zstd_level));
  bytes.resize(begin + written);
}

Result<size_t> compressed_bytes(std::span<const uint8_t> bytes) {
  const size_t size = ZSTD_findFrameCompressedSize(bytes.data(), bytes.size());
  if (ZSTD_isError(size))
    return data_loss(std::to_string(bytes.size()) +
                     " bytes do not begin with a zstd frame: " + ZSTD_getErrorName(size));
  return size;
}

Result<std::vector<uint8_t>> decompress(std::span<const uint8_t> bytes, size_t size) {
  if (ZSTD_getFrameContentSize(bytes.data(), bytes.size()) != size)
    return data_loss(std::to_string(bytes.size()) + " bytes are not one zstd frame of " +
                     std::to_string(size));
  std::vector<uint8_t> body(size);
  const size_t read = ZSTD_decompressDCtx(decompression_context(), body.data(), body.size(),
                                          bytes.data(), bytes.size());
  if (ZSTD_isError(read))
    return data_loss(std::string("does not decompress: ") + ZSTD_getErrorName(read));
  if (read != size)
    return data_loss("decompresses to " + std::to_string(read) + " bytes of " +
                     std::to_string(size));
  return body;
}

}  // namespace burnish
