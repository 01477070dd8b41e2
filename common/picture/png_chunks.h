#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace burnish {

/// Private to this folder: a chunk of a PNG file.
struct PngChunk {
  std::string_view kind;  ///< four letters
  std::span<const uint8_t> data;
  bool is_behind_pixels = false;
};

/// Lists the chunks of a PNG file in their order, without the header, the pixels and the end. Ends
/// where the file does not go on as one.
std::vector<PngChunk> list_png_chunks(std::span<const uint8_t> bytes);

}  // namespace burnish
