#pragma once

#include <cstdint>
#include <string>

namespace burnish {

/// Limits of the graphics card of the current context.
struct Capabilities {
  uint64_t triangles_max = 0;  ///< 0: no known limit
  std::string triangles_why;   ///< in words
};

Capabilities card_capabilities();

}  // namespace burnish
