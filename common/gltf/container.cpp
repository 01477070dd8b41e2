#include "common/gltf/container.h"

#include <cstring>
#include <string>

namespace burnish {

static uint32_t word_at(std::span<const uint8_t> bytes, size_t offset) {
  uint32_t word;
  std::memcpy(&word, bytes.data() + offset, sizeof word);
  return word;
}

bool is_glb(std::span<const uint8_t> bytes) {
  return bytes.size() >= sizeof kGlbMagic && word_at(bytes, 0) == kGlbMagic;
}

/// Takes a chunk's bytes from the front of `rest`. Fails: invalid_argument if they are not all
/// there.
static Result<std::span<const uint8_t>> take_chunk(std::span<const uint8_t>& rest,
                                                   const char* what) {
  const size_t length = rest.size() < kGlbChunkHeaderBytes ? 0 : word_at(rest, 0);
  if (rest.size() < kGlbChunkHeaderBytes || length > rest.size() - kGlbChunkHeaderBytes)
    return invalid_argument("the " + std::string(what) + " chunk has " + std::to_string(length) +
                            " bytes, but only " + std::to_string(rest.size()) +
                            " with its header are left");
  const auto chunk = rest.subspan(kGlbChunkHeaderBytes, length);
  rest = rest.subspan(kGlbChunkHeaderBytes + length);
  return chunk;
}

Result<GlbParts> split_glb(std::span<const uint8_t> bytes) {
  if (!is_glb(bytes) || bytes.size() < kGlbHeaderBytes)
    return invalid_argument("not a GLB file: it does not begin with 'glTF' and 8 bytes more");
  if (word_at(bytes, 4) != 2)
    return invalid_argument("GLB version " + std::to_string(word_at(bytes, 4)) +
                            " cannot be read, only 2");
  const uint32_t length = word_at(bytes, 8);
  if (length > bytes.size() || length < kGlbHeaderBytes)
    return invalid_argument("the GLB header promises " + std::to_string(length) +
                            " bytes, but the file has " + std::to_string(bytes.size()));
  std::span<const uint8_t> rest = bytes.first(length).subspan(kGlbHeaderBytes);
  if (rest.size() < kGlbChunkHeaderBytes || word_at(rest, 4) != kGlbJsonChunk)
    return invalid_argument("the first chunk is not JSON");
  GlbParts parts;
  ASSIGN_OR_RETURN(const auto json, take_chunk(rest, "JSON"));
  parts.json = {reinterpret_cast<const char*>(json.data()), json.size()};
  parts.has_bin = rest.size() >= kGlbChunkHeaderBytes && word_at(rest, 4) == kGlbBinChunk;
  if (parts.has_bin) {
    ASSIGN_OR_RETURN(parts.bin, take_chunk(rest, "BIN"));
  }
  parts.bytes_behind = bytes.size() - length;
  parts.rest = bytes.subspan(static_cast<size_t>(rest.data() - bytes.data()));
  return parts;
}

}  // namespace burnish
