#pragma once

#include <cstdint>
#include <cstdlib>
#include <png.h>
#include <span>
#include <string>
#include <vector>

namespace burnish {

/// A chunk of a PNG file beside the header, the pixels and the end.
struct RawChunk {
  std::string kind, data;
  bool is_behind_pixels = false;
  bool operator==(const RawChunk&) const = default;
};

/// A PNG file's pixels as they are stored, in whole bytes a channel; smaller ones are packed when
/// they are written.
struct RawPng {
  uint32_t width = 0, height = 0;
  int depth = 8;
  int kind = PNG_COLOR_TYPE_RGB;
  std::vector<uint16_t> pixels;  ///< channel by channel

  static RawPng noise(uint32_t width, uint32_t height, int depth, int kind) {
    RawPng png{width, height, depth, kind, {}};
    png.pixels.resize(size_t{width} * height * static_cast<size_t>(png.channels()));
    uint32_t state = 1;
    const uint32_t few = depth < 8 ? 1u << depth : (1u << depth) / 2;
    for (uint16_t& value : png.pixels) {
      state = 1664525 * state + 1013904223;
      value = static_cast<uint16_t>((state >> 8) % few);
    }
    return png;
  }

  int channels() const {
    if (kind == PNG_COLOR_TYPE_RGB) return 3;
    return kind == PNG_COLOR_TYPE_RGB_ALPHA ? 4 : kind == PNG_COLOR_TYPE_GRAY_ALPHA ? 2 : 1;
  }
  int colours() const { return channels() < 3 ? 1 : 3; }
  int max() const { return (1 << depth) - 1; }
  int value(uint32_t x, uint32_t y, int channel) const {
    return pixels[(size_t{y} * width + x) * static_cast<size_t>(channels()) +
                  static_cast<size_t>(channel)];
  }

  std::string encoded(const std::vector<RawChunk>& chunks = {}) const {
    std::string file;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    const auto append = [](png_structp to, png_bytep bytes, size_t count) {
      static_cast<std::string*>(png_get_io_ptr(to))->append(reinterpret_cast<char*>(bytes), count);
    };
    png_set_write_fn(png, &file, append, nullptr);
    png_set_IHDR(png, info, width, height, depth, kind, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (kind == PNG_COLOR_TYPE_PALETTE) {
      std::vector<png_color> palette;
      for (int i = 0; i < 1 << depth; ++i)
        palette.push_back({static_cast<png_byte>(10 * i), static_cast<png_byte>(200 - 9 * i), 40});
      png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    }
    png_write_info_before_PLTE(png, info);
    const auto put_chunks = [&](bool behind_pixels) {
      for (const RawChunk& chunk : chunks)
        if (chunk.is_behind_pixels == behind_pixels)
          png_write_chunk(png, reinterpret_cast<png_const_bytep>(chunk.kind.data()),
                          reinterpret_cast<png_const_bytep>(chunk.data.data()), chunk.data.size());
    };
    png_write_info(png, info);
    put_chunks(false);
    if (depth < 8) png_set_packing(png);
    if (depth == 16) png_set_swap(png);
    const size_t columns = size_t{width} * static_cast<size_t>(channels());
    for (uint32_t y = 0; y < height; ++y) {
      const uint16_t* row = &pixels[y * columns];
      const std::vector<uint8_t> small(row, row + columns);
      png_write_row(png, depth == 16 ? reinterpret_cast<png_const_bytep>(row) : small.data());
    }
    put_chunks(true);
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return file;
  }

  static RawPng decoded(std::span<const uint8_t> file) {
    RawPng read;
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    const auto give = [](png_structp from, png_bytep to, size_t count) {
      auto* left = static_cast<std::span<const uint8_t>*>(png_get_io_ptr(from));
      std::copy_n(left->begin(), count, to);
      *left = left->subspan(count);
    };
    png_set_read_fn(png, &file, give);
    png_read_info(png, info);
    read.width = png_get_image_width(png, info);
    read.height = png_get_image_height(png, info);
    read.depth = png_get_bit_depth(png, info);
    read.kind = png_get_color_type(png, info);
    if (read.depth == 16) png_set_swap(png);
    const size_t columns = size_t{read.width} * static_cast<size_t>(read.channels());
    for (uint32_t y = 0; y < read.height; ++y) {
      std::vector<uint16_t> row(columns);
      std::vector<uint8_t> small(columns);
      png_read_row(png, read.depth == 16 ? reinterpret_cast<png_bytep>(row.data()) : small.data(),
                   nullptr);
      if (read.depth != 16) row.assign(small.begin(), small.end());
      read.pixels.insert(read.pixels.end(), row.begin(), row.end());
    }
    png_destroy_read_struct(&png, &info, nullptr);
    return read;
  }
};

/// Returns the chunks of a PNG file in their order.
inline std::vector<RawChunk> chunks_in(std::span<const uint8_t> file) {
  std::vector<RawChunk> chunks;
  bool is_behind_pixels = false;
  for (size_t at = 8; at + 12 <= file.size();) {
    const size_t size = png_get_uint_32(&file[at]);
    const std::string kind(&file[at + 4], &file[at + 8]);
    is_behind_pixels |= kind == "IDAT";
    if (kind != "IHDR" && kind != "IDAT" && kind != "IEND")
      chunks.push_back({kind, std::string(file.begin() + at + 8, file.begin() + at + 8 + size),
                        is_behind_pixels});
    at += 12 + size;
  }
  return chunks;
}

}  // namespace burnish
