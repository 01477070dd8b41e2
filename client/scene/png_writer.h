#pragma once

#include <filesystem>

#include "client/scene/image.h"
#include "common/base/status.h"

namespace burnish {

/// Writes the picture as an 8-bit RGB PNG with its note, whole or not at all.
/// Fails: invalid_argument (size), not_found, permission_denied, resource_exhausted (disk full).
Status write_png(const Image& image, const std::filesystem::path& path);

}  // namespace burnish
