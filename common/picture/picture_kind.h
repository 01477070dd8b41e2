#pragma once

#include <cstdint>
#include <span>

#include "common/base/status.h"

namespace burnish {

/// Private to this folder: the kinds of pictures that are read and written.
enum class PictureKind { kPng, kJpeg, kWebp };

/// Returns the kind by a file's first bytes. Fails: invalid_argument above kPictureBytesMax;
/// unimplemented that names another kind, if it is a known one.
Result<PictureKind> kind_of_picture(std::span<const uint8_t> bytes);

}  // namespace burnish
