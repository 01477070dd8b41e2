#include "common/gltf/meshopt_attributes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

namespace burnish {

namespace {

constexpr uint8_t kVersion1 = 0xa1;
constexpr uint64_t kGroupElements = 16, kBlockBytesMax = 8192, kBlockElementsMax = 256;
constexpr uint64_t kTailBytesMin = 24, kChannelBytes = 4;

/// Bytes that are taken from the front.
class MeshoptBytes {
 public:
  explicit MeshoptBytes(std::span<const uint8_t> bytes) : rest_(bytes) {}

  /// Returns nothing if there are fewer.
  std::optional<std::span<const uint8_t>> take(uint64_t count) {
    if (count > rest_.size()) return std::nullopt;
    const auto taken = rest_.first(count);
    rest_ = rest_.subspan(count);
    return taken;
  }
  bool is_empty() const { return rest_.empty(); }

 private:
  std::span<const uint8_t> rest_;
};

/// The deltas of one byte of the elements of a block; whole groups.
using MeshoptDeltas = std::array<uint8_t, kBlockElementsMax>;

/// Reads a group of deltas. One whose bits are all 1 follows the group as a byte.
bool read_group(MeshoptBytes& packed, unsigned bits, uint8_t* deltas) {
  const auto fixed = packed.take(kGroupElements * bits / 8);
  if (!fixed) return false;
  if (bits == 8) std::ranges::copy(*fixed, deltas);
  if (bits == 0 || bits == 8) return true;
  const unsigned in_byte = 8 / bits, escape = (1u << bits) - 1;
  for (unsigned i = 0; i < kGroupElements; ++i) {
    const unsigned place = i % in_byte;
    const unsigned shift = bits == 1 ? place : 8 - bits * (place + 1);
    deltas[i] = static_cast<uint8_t>((*fixed)[i / in_byte] >> shift & escape);
    if (deltas[i] != escape) continue;
    const auto whole = packed.take(1);
    if (!whole) return false;
    deltas[i] = whole->front();
  }
  return true;
}

/// Reads the deltas of one byte of `count` elements. `control` says how they are packed.
bool read_deltas(MeshoptBytes& packed, unsigned control, uint64_t count, MeshoptDeltas& deltas) {
  constexpr unsigned kZeros = 2, kAsTheyAre = 3;
  constexpr unsigned kBits[2][4] = {{0, 1, 2, 4}, {1, 2, 4, 8}};
  deltas.fill(0);
  if (control == kZeros) return true;
  if (control == kAsTheyAre) {
    const auto bytes = packed.take(count);
    if (bytes) std::ranges::copy(*bytes, deltas.begin());
    return bytes.has_value();
  }
  const uint64_t groups = (count + kGroupElements - 1) / kGroupElements;
  const auto modes = packed.take((groups + 3) / 4);
  if (!modes) return false;
  for (uint64_t g = 0; g < groups; ++g) {
    const unsigned mode = (*modes)[g / 4] >> (2 * (g % 4)) & 3;
    if (!read_group(packed, kBits[control][mode], deltas.data() + g * kGroupElements)) return false;
  }
  return true;
}

template <typename Whole>
Whole unzigzagged(Whole value) {
  return static_cast<Whole>((value >> 1) ^ -(value & 1));
}

/// Adds a delta to the same channel of the element before. `mode` is the channel's: the deltas are
/// those of bytes (0), of pairs of bytes (1), or bits that differ (2) with a rotation.
uint32_t add_delta(uint32_t before, uint32_t delta, uint8_t mode) {
  if ((mode & 15) == 2) return before ^ std::rotr(delta, mode >> 4);
  uint32_t sum = 0;
  if (mode == 1) {
    for (const int shift : {0, 16}) {
      const auto step = unzigzagged(static_cast<uint16_t>(delta >> shift));
      sum |= static_cast<uint32_t>(static_cast<uint16_t>((before >> shift) + step)) << shift;
    }
    return sum;
  }
  for (const int shift : {0, 8, 16, 24}) {
    const auto step = unzigzagged(static_cast<uint8_t>(delta >> shift));
    sum |= static_cast<uint32_t>(static_cast<uint8_t>((before >> shift) + step)) << shift;
  }
  return sum;
}

bool is_channel_mode(uint8_t mode) {
  return (mode & 15) == 2 || mode <= 1;
}

uint32_t channel_at(const uint8_t* bytes) {
  uint32_t value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

/// Unpacks `count` elements to `out`. `before` is the element before them.
bool unpack_block(MeshoptBytes& packed, std::span<const uint8_t> modes, uint64_t count,
                  const uint8_t* before, uint8_t* out) {
  const uint64_t stride = kChannelBytes * modes.size();
  const auto controls = packed.take(modes.size());
  if (!controls) return false;
  std::array<MeshoptDeltas, kChannelBytes> deltas;
  for (uint64_t channel = 0; channel < modes.size(); ++channel) {
    for (unsigned b = 0; b < kChannelBytes; ++b)
      if (!read_deltas(packed, (*controls)[channel] >> (2 * b) & 3, count, deltas[b])) return false;
    uint32_t value = channel_at(before + kChannelBytes * channel);
    for (uint64_t i = 0; i < count; ++i) {
      uint32_t delta = 0;
      for (unsigned b = 0; b < kChannelBytes; ++b) delta |= uint32_t{deltas[b][i]} << (8 * b);
      value = add_delta(value, delta, modes[channel]);
      std::memcpy(out + i * stride + kChannelBytes * channel, &value, sizeof value);
    }
  }
  return true;
}

template <typename Unsigned, typename Signed>
void turn_into_rgba(uint8_t* element) {
  std::array<Unsigned, 4> colour;
  std::memcpy(colour.data(), element, sizeof colour);
  const int y = colour[0], co = static_cast<Signed>(colour[1]), cg = static_cast<Signed>(colour[2]);
  const int range = (1 << std::bit_width(static_cast<unsigned>(colour[3]))) - 1;
  const int half_alpha = colour[3] & (range >> 1);
  const int rgba[] = {y + co - cg, y + cg, y - co - cg, half_alpha << 1 | (half_alpha & 1)};
  constexpr int kMax = static_cast<Unsigned>(-1);
  for (size_t i = 0; i < 4; ++i) {
    const float scaled = static_cast<float>(rgba[i]) *
                         (static_cast<float>(kMax) / static_cast<float>(std::max(range, 1)));
    colour[i] = static_cast<Unsigned>(std::clamp(std::lround(scaled), 0L, static_cast<long>(kMax)));
  }
  std::memcpy(element, colour.data(), sizeof colour);
}

}  // namespace

bool is_meshopt_version_1(std::span<const uint8_t> packed) {
  return !packed.empty() && packed[0] == kVersion1;
}

bool unpack_meshopt_attributes(std::span<const uint8_t> packed, uint64_t stride,
                               std::span<uint8_t> elements) {
  const uint64_t tail = stride + stride / kChannelBytes;
  const uint64_t padded_tail = std::max(tail, kTailBytesMin);
  if (!is_meshopt_version_1(packed) || packed.size() < 1 + padded_tail) return false;
  const auto modes = packed.last(stride / kChannelBytes);
  if (!std::ranges::all_of(modes, is_channel_mode)) return false;
  MeshoptBytes blocks(packed.subspan(1, packed.size() - 1 - padded_tail));
  const uint64_t block_max =
      std::min(kBlockBytesMax / stride / kGroupElements * kGroupElements, kBlockElementsMax);
  const uint8_t* before = packed.last(tail).data();
  const uint64_t count = elements.size() / stride;
  for (uint64_t done = 0; done < count;) {
    const uint64_t block = std::min(count - done, block_max);
    uint8_t* out = elements.data() + done * stride;
    if (!unpack_block(blocks, modes, block, before, out)) return false;
    before = out + (block - 1) * stride;
    done += block;
  }
  return blocks.is_empty();
}

void apply_meshopt_colour_filter(std::span<uint8_t> elements, uint64_t stride) {
  for (uint64_t at = 0; at + stride <= elements.size(); at += stride) {
    if (stride == 4) turn_into_rgba<uint8_t, int8_t>(elements.data() + at);
    if (stride == 8) turn_into_rgba<uint16_t, int16_t>(elements.data() + at);
  }
}

}  // namespace burnish
