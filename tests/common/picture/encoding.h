#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <jpeglib.h>
#include <png.h>
#include <string>
#include <vector>

#include "common/picture/picture.h"

namespace burnish {

/// Returns a picture whose pixels a function gives.
template <typename Pixel>
Picture drawn(uint32_t width, uint32_t height, const Pixel& pixel) {
  Picture picture{width, height, {}};
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x) picture.pixels.push_back(pixel(x, y));
  return picture;
}

/// Returns the picture as a PNG file.
inline std::string png_of(const Picture& picture) {
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  header.width = picture.width;
  header.height = picture.height;
  header.format = PNG_FORMAT_RGBA;
  png_alloc_size_t bytes = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string file(bytes, '\0');
  if (!png_image_write_to_memory(&header, file.data(), &bytes, 0, picture.pixels.data(), 0,
                                 nullptr))
    std::abort();
  file.resize(bytes);
  return file;
}

/// Returns the picture as an interlaced PNG file.
inline std::string interlaced_png_of(const Picture& picture) {
  std::string file;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  const auto append = [](png_structp to, png_bytep bytes, size_t count) {
    static_cast<std::string*>(png_get_io_ptr(to))->append(reinterpret_cast<char*>(bytes), count);
  };
  png_set_write_fn(png, &file, append, nullptr);
  png_set_IHDR(png, info, picture.width, picture.height, 8, PNG_COLOR_TYPE_RGB_ALPHA,
               PNG_INTERLACE_ADAM7, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  std::vector<png_bytep> rows;
  for (uint32_t y = 0; y < picture.height; ++y)
    rows.push_back(reinterpret_cast<png_bytep>(const_cast<Rgba8*>(&picture.at(0, y))));
  png_set_rows(png, info, rows.data());
  png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  png_destroy_write_struct(&png, &info);
  return file;
}

/// How a JPEG file is written.
struct JpegStyle {
  bool is_progressive = false;  ///< several scans
  int sampling = 2;             ///< pixels along a side for one sample of chroma: 1 or 2
  bool is_grey = false;
  bool has_arithmetic_codes = false;
  std::string comment = {};
  int quality = 100;
  int restart_rows = 0;
};

/// Returns the picture as a JPEG file.
inline std::string jpeg_of(const Picture& picture, const JpegStyle& style) {
  jpeg_compress_struct jpeg = {};
  jpeg_error_mgr errors = {};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = picture.width;
  jpeg.image_height = picture.height;
  jpeg.input_components = 4;
  jpeg.in_color_space = JCS_EXT_RGBA;
  jpeg_set_defaults(&jpeg);
  if (style.is_grey) jpeg_set_colorspace(&jpeg, JCS_GRAYSCALE);
  jpeg.comp_info[0].h_samp_factor = jpeg.comp_info[0].v_samp_factor = style.sampling;
  jpeg_set_quality(&jpeg, style.quality, TRUE);
  jpeg.restart_in_rows = style.restart_rows;
  jpeg.arith_code = style.has_arithmetic_codes ? TRUE : FALSE;
  if (style.is_progressive) jpeg_simple_progression(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  if (!style.comment.empty())
    jpeg_write_marker(&jpeg, JPEG_COM, reinterpret_cast<const JOCTET*>(style.comment.data()),
                      static_cast<unsigned>(style.comment.size()));
  while (jpeg.next_scanline < jpeg.image_height) {
    const auto* first = &picture.pixels[size_t{jpeg.next_scanline} * picture.width];
    JSAMPROW row = reinterpret_cast<JSAMPROW>(const_cast<Rgba8*>(first));
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  std::string file(reinterpret_cast<const char*>(bytes), size);
  jpeg_destroy_compress(&jpeg);
  std::free(bytes);
  return file;
}

/// Returns the picture as a JPEG file of the best quality.
inline std::string jpeg_of(const Picture& picture, bool is_progressive = false) {
  return jpeg_of(picture, JpegStyle{.is_progressive = is_progressive});
}

}  // namespace burnish
