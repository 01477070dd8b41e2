#pragma once

#include <filesystem>

#include "client/scene/image.h"

namespace burnish {

/// Reads a PNG file as RGB. A picture with a side above `side_max` is refused before it is decoded.
/// Fails: not_found, as errno says; data_loss (damaged); invalid_argument (too large).
Result<Image> read_png(const std::filesystem::path& path, int side_max);

}  // namespace burnish
