#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "common/mesh/reading/text_scanner.h"

namespace burnish {

inline constexpr size_t kStlHeaderBytes = 84;  ///< 80 of text, then the number of facets
inline constexpr size_t kStlFacetBytes = 50;   ///< normal, three corners, an attribute of two bytes
inline constexpr size_t kStlNormalBytes = 12;

/// Returns the size of a binary file by its number of facets. Needs: a whole header.
uint64_t promised_stl_bytes(std::span<const uint8_t> bytes);

/// Returns whether the file is text. Binary files may begin with "solid" too. Then their length, or
/// bytes in the header that text never has, reveal them.
bool is_stl_text(std::span<const uint8_t> bytes);

/// Returns the first word of a line of text, in small letters. Some programs write "end loop" for
/// "endloop"; both are one word here.
std::string next_stl_keyword(TextScanner& scanner);

}  // namespace burnish
