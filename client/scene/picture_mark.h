#pragma once

#include <string>

#include "client/scene/image.h"

namespace burnish {

/// Writes words into the lower left corner of a picture, and makes them its note. A picture that is
/// too narrow shows their beginning. Needs: small letters, digits, spaces and ",.%".
void mark_picture(Image& image, const std::string& words);

}  // namespace burnish
