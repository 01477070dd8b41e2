#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "common/base/status.h"
#include "common/base/types.h"

namespace burnish {

/// Says what a picture's header announces.
struct PictureSize {
  uint32_t width = 0;           ///< pixels
  uint32_t height = 0;          ///< pixels
  uint64_t decoding_bytes = 0;  ///< of memory that its decoder takes beside the file
};

/// Pixels of one row, sRGB with alpha: every `step`-th from `first` on.
struct PixelRun {
  uint32_t y = 0;
  uint32_t first = 0;
  uint32_t step = 1;
  std::span<const Rgba8> pixels;
};

/// Takes a picture as it is decoded.
struct PictureTaker {
  /// Hears the size before anything is decoded. A failure ends the reading.
  std::function<Status(const PictureSize&)> begin;
  /// Gets each pixel once. The rows of an interlaced PNG come in several passes.
  std::function<void(const PixelRun&)> take;
  /// Is asked for each row, and between the parts of a JPEG of several scans. Returns false to end
  /// the reading. Null: it goes on.
  std::function<bool()> goes_on = {};
};

/// Decodes a PNG, JPEG or WebP file row by row, so that a PNG or JPEG takes no memory for its
/// pixels. A JPEG of several scans takes memory for its coefficients, a WebP for all pixels. `name`
/// is for messages. Fails: unimplemented (another kind of picture); invalid_argument that names the
/// value and the limit (too large, damaged, cut off); resource_exhausted; cancelled; as begin()
/// does, with the name and the size.
Status read_picture_rows(std::span<const uint8_t> bytes, const std::string& name,
                         const PictureTaker& taker);

/// Returns what the header of a PNG, JPEG or WebP file announces. Fails: as read_picture_rows().
Result<PictureSize> read_picture_size(std::span<const uint8_t> bytes, const std::string& name);

}  // namespace burnish
