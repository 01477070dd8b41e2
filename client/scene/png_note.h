#pragma once

#include <string>
#include <string_view>

namespace burnish {

/// Returns the content of a PNG's part "tEXt" that describes its picture. Needs: printable ASCII.
inline std::string png_note(std::string_view text) {
  return std::string("Description", 12).append(text);  // with a zero between
}

}  // namespace burnish
