#include "tests/bench/codec_alternatives.h"

#include <chrono>
#include <meshoptimizer.h>
#include <zstd.h>

namespace burnish {

namespace {

using Bytes = std::vector<uint8_t>;
using Value = std::array<int16_t, 4>;  // x, y, z and padding: meshoptimizer needs multiples of 4
using Tiles = std::vector<std::vector<Value>>;

int16_t rounded(int32_t change, int step_shift) {
  const int half = (1 << step_shift) >> 1;
  const int32_t magnitude = std::min((std::abs(change) + half) >> step_shift, 32767);
  return static_cast<int16_t>(change < 0 ? -magnitude : magnitude);
}

Tiles changed_tiles(const FrameLayout& layout, const FrameState& held, const FrameSample& sample,
                    int step_shift) {
  Tiles tiles;
  for (int tile = 0; tile < layout.tile_count(); ++tile) {
    const size_t size = layout.tile_size(tile);
    std::vector<int32_t> before(3 * size);
    held.read_tile(tile, before);
    const auto wanted = sample.tile(layout, tile);
    std::vector<Value> values(size);
    bool changed = false;
    for (size_t at = 0; at < 3 * size; ++at) {
      const int16_t k = rounded(wanted[at] - before[at], step_shift);
      values[at % size][at / size] = k;
      changed |= k != 0;
    }
    if (changed) tiles.push_back(std::move(values));
  }
  return tiles;
}

size_t compressed_size(const Bytes& bytes) {
  Bytes out(ZSTD_compressBound(bytes.size()));
  return ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 1);
}

Bytes as_int16(const Tiles& tiles) {
  Bytes bytes;
  for (const auto& tile : tiles)
    for (const Value& value : tile)
      for (int axis = 0; axis < 3; ++axis) {
        bytes.push_back(static_cast<uint8_t>(value[axis]));
        bytes.push_back(static_cast<uint8_t>(value[axis] >> 8));
      }
  return bytes;
}

Bytes as_byte_planes(const Tiles& tiles) {
  Bytes low, high;
  for (int axis = 0; axis < 3; ++axis)
    for (const auto& tile : tiles) {
      int previous = 0;
      for (const Value& value : tile) {
        const int difference = value[axis] - previous;
        previous = value[axis];
        const auto zigzag = static_cast<uint32_t>(difference << 1 ^ difference >> 31);
        low.push_back(static_cast<uint8_t>(zigzag));
        high.push_back(static_cast<uint8_t>(zigzag >> 8));
      }
    }
  low.insert(low.end(), high.begin(), high.end());
  return low;
}

Bytes as_vertex_codec(const Tiles& tiles) {
  Bytes bytes, tile_bytes(meshopt_encodeVertexBufferBound(kTileValues, sizeof(Value)));
  for (const auto& tile : tiles) {
    const size_t size = meshopt_encodeVertexBuffer(tile_bytes.data(), tile_bytes.size(),
                                                   tile.data(), tile.size(), sizeof(Value));
    bytes.insert(bytes.end(), tile_bytes.begin(),
                 tile_bytes.begin() + static_cast<std::ptrdiff_t>(size));
  }
  return bytes;
}

}  // namespace

std::vector<AlternativeCost> alternative_costs(const FrameLayout& layout, const FrameState& held,
                                               const FrameSample& sample, int step_shift) {
  const std::pair<const char*, Bytes (*)(const Tiles&)> ways[] = {
      {"int16 + zstd", as_int16},
      {"byte planes + zstd", as_byte_planes},
      {"meshoptimizer + zstd", as_vertex_codec}};
  std::vector<AlternativeCost> costs;
  for (const auto& [name, write] : ways) {
    const auto start = std::chrono::steady_clock::now();
    const Tiles tiles = changed_tiles(layout, held, sample, step_shift);
    const size_t bytes = compressed_size(write(tiles));
    const std::chrono::duration<double, std::milli> taken =
        std::chrono::steady_clock::now() - start;
    costs.push_back({name, bytes, taken.count()});
  }
  return costs;
}

}  // namespace burnish
