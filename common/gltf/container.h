#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "common/base/status.h"

namespace burnish {

/// The parts of a binary glTF file: a header of 12 bytes, then chunks. A chunk is its length and
/// its type, 4 bytes each, and its bytes.
struct GlbParts {
  std::string_view json;         ///< with the spaces that fill it up
  std::span<const uint8_t> bin;  ///< the second chunk's bytes if it is "BIN"
  bool has_bin = false;
  std::span<const uint8_t> rest;  ///< other chunks, then bytes behind the file's own length
  uint64_t bytes_behind = 0;      ///< of `rest` that the file's own length leaves out
};

inline constexpr size_t kGlbHeaderBytes = 12;
inline constexpr size_t kGlbChunkHeaderBytes = 8;
inline constexpr uint32_t kGlbMagic = 0x46546C67;      // "glTF"
inline constexpr uint32_t kGlbJsonChunk = 0x4E4F534A;  // "JSON"
inline constexpr uint32_t kGlbBinChunk = 0x004E4942;   // "BIN"

/// Returns whether a file begins as a binary glTF file does.
bool is_glb(std::span<const uint8_t> bytes);

/// Splits a binary glTF file. Fails: invalid_argument if it is of another version or cut.
Result<GlbParts> split_glb(std::span<const uint8_t> bytes);

}  // namespace burnish
