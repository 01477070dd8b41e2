#include "common/mesh/stl/stl_layout.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace burnish {

static constexpr size_t kKeywordBytesMax = 64;  // longer words are none, and only shown

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
  return scanner.next_line() && next_stl_keyword(scanner) == kSolid;
}

static std::string in_small_letters(std::string_view token) {
  std::string text(token.substr(0, kKeywordBytesMax));
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::string next_stl_keyword(TextScanner& scanner) {
  std::string keyword = in_small_letters(scanner.next_token());
  if (keyword == "end") keyword += in_small_letters(scanner.next_token());
  return keyword;
}

}  // namespace burnish
