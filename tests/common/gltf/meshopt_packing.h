#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace burnish {

/// Packs attributes as appendix A of KHR_meshopt_compression says for version 1. It takes each way
/// of packing in turn, not the shortest.
class MeshoptPacking {
 public:
  /// `modes` are those of the channels: 4 bytes of an element each.
  explicit MeshoptPacking(std::vector<uint8_t> modes) : modes_(std::move(modes)) {}

  std::string packed(const std::string& elements) {
    const size_t stride = 4 * modes_.size(), count = elements.size() / stride;
    const size_t block_max = std::min<size_t>(8192 / stride / 16 * 16, 256);
    const std::string baseline(stride, '\x11');
    std::string bytes = "\xa1", before = baseline;
    for (size_t done = 0; done < count; done += block_max) {
      const size_t block = std::min(count - done, block_max);
      add_block(before, elements.substr(done * stride, block * stride), bytes);
      before = elements.substr((done + block - 1) * stride, stride);
    }
    const std::string tail = baseline + std::string(modes_.begin(), modes_.end());
    return bytes + std::string(std::max<size_t>(tail.size(), 24) - tail.size(), '\0') + tail;
  }

 private:
  static uint32_t word_at(const std::string& bytes, size_t at) {
    uint32_t word;
    std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
  }

  /// A difference in `bits`, with its sign in the lowest one.
  static uint32_t zigzag(uint32_t difference, int bits) {
    const uint32_t all = (1u << bits) - 1;
    const uint32_t doubled = difference << 1;
    return ((difference >> (bits - 1) & 1) != 0 ? ~doubled : doubled) & all;
  }

  static uint32_t delta(uint32_t before, uint32_t value, uint8_t mode) {
    if ((mode & 15) == 2) return std::rotl(before ^ value, mode >> 4);
    const int bits = mode == 1 ? 16 : 8;
    uint32_t deltas = 0;
    for (int shift = 0; shift < 32; shift += bits)
      deltas |= zigzag((value >> shift) - (before >> shift), bits) << shift;
    return deltas;
  }

  void add_block(const std::string& before, const std::string& elements, std::string& bytes) {
    const size_t channels = modes_.size(), stride = 4 * channels, count = elements.size() / stride;
    std::string controls, data;
    for (size_t c = 0; c < channels; ++c) {
      std::array<std::string, 4> deltas;
      for (size_t i = 0; i < count; ++i) {
        const uint32_t last =
            i == 0 ? word_at(before, 4 * c) : word_at(elements, (i - 1) * stride + 4 * c);
        const uint32_t step = delta(last, word_at(elements, i * stride + 4 * c), modes_[c]);
        for (size_t b = 0; b < 4; ++b) deltas[b] += static_cast<char>(step >> (8 * b));
      }
      unsigned control = 0;
      for (size_t b = 0; b < 4; ++b) control |= add_deltas(deltas[b], data) << (2 * b);
      controls += static_cast<char>(control);
    }
    bytes += controls + data;
  }

  unsigned add_deltas(std::string deltas, std::string& data) {
    const bool are_zeros = deltas.find_first_not_of('\0') == std::string::npos;
    if (are_zeros) return 2;
    if (turn_++ % 3 == 2) {
      data += deltas;
      return 3;
    }
    const unsigned control = turn_ % 2;
    deltas.resize((deltas.size() + 15) / 16 * 16);
    std::string modes((deltas.size() / 16 + 3) / 4, '\0'), groups;
    for (size_t g = 0; g < deltas.size() / 16; ++g) {
      const std::string group = deltas.substr(16 * g, 16);
      unsigned mode = turn_++ % 4;
      // The only width that cannot take any value is that of zeros.
      if (control == 0 && mode == 0 && group.find_first_not_of('\0') != std::string::npos) mode = 3;
      constexpr unsigned kBits[2][4] = {{0, 1, 2, 4}, {1, 2, 4, 8}};
      add_group(group, kBits[control][mode], groups);
      modes[g / 4] = static_cast<char>(modes[g / 4] | static_cast<char>(mode << (2 * (g % 4))));
    }
    data += modes + groups;
    return control;
  }

  static void add_group(const std::string& group, unsigned bits, std::string& data) {
    if (bits == 0) return;
    if (bits == 8) {
      data += group;
      return;
    }
    const unsigned in_byte = 8 / bits, escape = (1u << bits) - 1;
    std::string fixed(16 / in_byte, '\0'), whole;
    for (unsigned i = 0; i < 16; ++i) {
      const auto value = static_cast<uint8_t>(group[i]);
      const unsigned place = i % in_byte;
      const unsigned shift = bits == 1 ? place : 8 - bits * (place + 1);
      char& byte = fixed[i / in_byte];
      byte =
          static_cast<char>(byte | static_cast<char>(std::min<unsigned>(value, escape) << shift));
      if (value >= escape) whole += group[i];
    }
    data += fixed + whole;
  }

  const std::vector<uint8_t> modes_;
  unsigned turn_ = 0;
};

}  // namespace burnish
