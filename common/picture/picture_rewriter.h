#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "common/picture/picture_rows.h"

namespace burnish {

/// Red, green and blue of a pixel in sRGB, as fine as its file has them. Those of a grey picture
/// are equal.
using FileTexel = std::array<uint16_t, 3>;

/// Rows of a picture on their way from its file to another one.
struct FileRows {
  uint32_t first = 0;  ///< from the top
  uint32_t count = 0;
  uint32_t width = 0;           ///< pixels
  uint16_t max = 255;           ///< of a channel: 255 or 65535
  std::span<FileTexel> texels;  ///< width * count
};

/// Changes a picture.
struct PictureEditor {
  /// Hears the size before anything is decoded, with the memory that the rewriting takes beside
  /// the file. A failure ends it.
  std::function<Status(const PictureSize&)> begin;
  /// Changes some rows. Gets all rows from top to bottom, in bands of a few dozen. A failure ends
  /// the rewriting.
  std::function<Status(const FileRows&)> change;
  /// Is asked for each row. Returns false to end the rewriting. Null: it goes on.
  std::function<bool()> goes_on = {};
};

/// A picture's file with other pixels.
struct RewrittenPicture {
  std::vector<uint8_t> bytes;  ///< empty if no pixel changed
  uint64_t texels = 0;         ///< that changed
  std::string note;            ///< what else is different, in words; empty: nothing
};

/// Writes a PNG, JPEG or WebP file again with some pixels changed.
///
/// PNG: same depth, colours and chunks; other pixels stay equal. A palette becomes RGB, and a grey
/// of 1 to 4 bits one of 8. An interlaced picture is in memory as a whole, and is not interlaced
/// afterwards.
///
/// JPEG: only blocks with a changed pixel get new coefficients, in the file's own tables and
/// sampling. So no pixel outside their MCUs and a ring of one around them changes. Markers stay,
/// and a progressive file is progressive. All coefficients are in memory: two bytes a sample.
///
/// WebP: packed without loss, so other pixels stay equal. All are in memory.
///
/// Fails: unimplemented naming what it cannot write (CMYK, arithmetic coding, another gamma, a
/// WebP's colour profile, another kind of picture); otherwise as read_picture_rows(); as the editor
/// does.
Result<RewrittenPicture> rewrite_picture(std::span<const uint8_t> bytes, const std::string& name,
                                         const PictureEditor& editor);

}  // namespace burnish
