#pragma once

#include <string>

#include "client/scene/image.h"

namespace burnish {

/// Returns a small picture as an address that holds it: "data:image/png;base64,...".
std::string picture_address(const Image& image);

}  // namespace burnish
