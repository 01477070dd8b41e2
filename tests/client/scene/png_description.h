#pragma once

#include <cstdio>
#include <png.h>
#include <string>
#include <string_view>

namespace burnish {

/// Returns what a PNG says of its picture, as libpng reads it; empty: nothing, or the PNG is
/// damaged.
inline std::string png_description(std::string png) {
  FILE* const file = fmemopen(png.data(), png.size(), "rb");
  png_structp reader = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(reader);
  const char* found = "";
  if (setjmp(png_jmpbuf(reader)) == 0) {
    png_init_io(reader, file);
    png_read_png(reader, info, PNG_TRANSFORM_IDENTITY, nullptr);
    png_textp texts = nullptr;
    int count = 0;
    png_get_text(reader, info, &texts, &count);
    for (int i = 0; i < count; ++i)
      if (std::string_view(texts[i].key) == "Description") found = texts[i].text;
  }
  std::string description = found;
  png_destroy_read_struct(&reader, &info, nullptr);
  std::fclose(file);
  return description;
}

}  // namespace burnish
