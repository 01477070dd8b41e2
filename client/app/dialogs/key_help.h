#pragma once

#include "client/model/input/bindings.h"

namespace burnish {

/// A window with all keys and what they do.
void draw_key_help(const Bindings& bindings, bool& is_open);

}  // namespace burnish
