#pragma once

#include <toml++/toml.h>

#include "client/scene/lighting.h"

namespace burnish {

toml::table to_toml(const Lighting& lighting);

/// Returns the default light for a table with values outside their limits.
Lighting lighting_of(const toml::table& table);

}  // namespace burnish
