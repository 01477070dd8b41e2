#pragma once

#include <array>
#include <cstddef>

namespace burnish {

/// A text of GLSL without comments, indentation and empty lines, which browsers need not load.
template <size_t kSize>
struct Glsl {
  consteval Glsl(const char (&source)[kSize]) {  // NOLINT: literals become one
    size_t size = 0;
    bool is_comment = false, is_line_begun = false;
    for (size_t at = 0; at < kSize; ++at) {
      const char c = source[at];
      if (c == '\n') is_comment = false;
      if (c == '/' && source[at + 1] == '/') is_comment = true;
      const bool is_blank = c == ' ' || c == '\n';
      if (is_comment || (!is_line_begun && is_blank)) continue;
      is_line_begun = c != '\n';
      text[size++] = c;
    }
  }

  std::array<char, kSize> text{};  ///< ends with zeros
};

template <Glsl kText>
consteval const char* operator""_glsl() {
  return kText.text.data();
}

}  // namespace burnish
