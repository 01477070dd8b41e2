#pragma once

#include <cstdint>
#include <string>

namespace burnish {

/// What the card of the current context can hold.
struct Capabilities {
  uint64_t triangles_max = 0;  ///< 0: no limit is known
  std::string triangles_why;   ///< in words
};

Capabilities card_capabilities();

}  // namespace burnish
