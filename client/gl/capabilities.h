#pragma once

#include <cstdint>

namespace burnish {

/// What is known of the graphics card of the current context.
struct Capabilities {
  bool is_software = false;  ///< there is none: the processor draws
  uint64_t free_bytes = 0;   ///< of the card's memory; 0: unknown
};

Capabilities card_capabilities();

}  // namespace burnish
