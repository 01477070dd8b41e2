#pragma once

#include <cstddef>
#include <string>

namespace burnish {

/// Says what would be lost.
struct Unsaved {
  size_t edits = 0;
  size_t files = 0;  ///< exports that are being written; they go on after their session

  bool is_there() const { return edits + files > 0; }
};

/// Returns e.g. "1 edit is not saved, 1 file is not written".
std::string text_of(const Unsaved& unsaved);

}  // namespace burnish
