#pragma once

#include <string>

#include "client/scene/image.h"

namespace burnish {

/// Returns a picture as PNG with its note. Its pixels are not compressed: every reader takes it,
/// and it needs no library.
std::string stored_png(const Image& image);

}  // namespace burnish
