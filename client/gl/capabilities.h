#pragma once

#include <cstdint>

namespace burnish {

/// The graphics card of the current context, as far as it is known.
struct Capabilities {
  bool is_software = false;  ///< there is none: the processor draws
  uint64_t free_bytes = 0;   ///< of the card's memory; 0: unknown
};

Capabilities card_capabilities();

}  // namespace burnish
