#include "common/mesh/stl_layout.h"

#include <algorithm>
#include <cstring>
#include <string_view>

#include "common/mesh/text_scanner.h"
#include "common/mesh/text_values.h"

namespace burnish {

uint64_t promised_stl_bytes(std::span<const uint8_t> bytes) {
  uint32_t facets;
  std::memcpy(&facets, bytes.data() + kStlHeaderBytes - sizeof facets, sizeof facets);
  return kStlHeaderBytes + uint64_t{facets} * kStlFacetBytes;
}

bool is_stl_text(std::span<const uint8_t> bytes) {
  constexpr std::string_view kSolid = "solid";
  if (bytes.size() >= kStlHeaderBytes && promised_stl_bytes(bytes) == bytes.size()) return false;
  const auto is_text = [](uint8_t c) { return c >= ' ' || (c >= '\t' && c <= '\r'); };
  const auto start = bytes.first(std::min<size_t>(bytes.size(), 2 * kStlHeaderBytes));
  if (!std::all_of(start.begin(), start.end(), is_text)) return false;
  TextScanner scanner(start, "");
  return scanner.next_line() && equals_ignoring_case(scanner.next_token(), kSolid);
}

}  // namespace burnish
