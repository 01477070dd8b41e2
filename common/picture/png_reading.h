#pragma once

#include <csetjmp>
#include <cstdint>
#include <png.h>
#include <span>
#include <string>

#include "common/base/status.h"

namespace burnish {

/// Private to this folder: the state of one decoding. libpng leaves by longjmp, so no frame between
/// has a destructor.
struct PngReading {
  explicit PngReading(std::span<const uint8_t> file);
  ~PngReading() { png_destroy_read_struct(&png, &info, nullptr); }
  PngReading(const PngReading&) = delete;
  PngReading& operator=(const PngReading&) = delete;

  Status failure() const;
  bool is_interlaced() const { return png_get_interlace_type(png, info) != PNG_INTERLACE_NONE; }

  std::span<const uint8_t> left;
  png_structp png = nullptr;
  png_infop info = nullptr;  ///< null: no memory
  std::string message;
  bool is_cancelled = false;
};

/// Reads all before the pixels. Returns false where libpng failed; failure() then says why.
bool read_png_header(PngReading& reading);

}  // namespace burnish
