#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "common/base/status.h"
#include "common/pages/page_format.h"

namespace burnish {

/// The header of an encoded page, as it lies there (page_format.h).
struct PageHeader {
  std::array<char, 4> magic = kPageMagic;
  uint8_t version = kPageFormatVersion;
  uint8_t flags = 0;
  uint8_t place_bytes = 0;
  uint8_t zero8 = 0;
  uint32_t id = 0;
  uint16_t vertices = 0;
  uint16_t triangles = 0;
  uint16_t border_vertices = 0;
  uint16_t patches = 0;
  uint16_t steps = 0;
  uint16_t named_vertices = 0;
  uint16_t named_patches = 0;
  uint16_t zero16 = 0;
  std::array<uint32_t, 3> first_position = {};
  uint64_t checksum = 0;

  bool has_all_normals() const { return (flags & kAllNormals) != 0; }
  bool has_colours() const { return (flags & kColours) != 0; }

  static constexpr uint8_t kAllNormals = 1;
  static constexpr uint8_t kColours = 2;
};
static_assert(sizeof(PageHeader) == kPageHeaderBytes);

enum class PageSection {
  kFiner,
  kSteps,
  kNamedVertices,
  kTurns,
  kNamedPatches,
  kBorder,
  kPlaces,
  kNormals,
  kColours,
};
inline constexpr size_t kPageSections = 9;

/// Returns the bytes of each section before compression.
std::array<size_t, kPageSections> section_bytes(const PageHeader& header);

/// Reads and checks the header, and the checksum of all. Fails: data_loss, unimplemented.
Result<PageHeader> read_page_header(std::span<const uint8_t> bytes);

/// Writes the header with its checksum before the body that lies behind it already.
void seal_page(PageHeader header, std::span<uint8_t> bytes);

}  // namespace burnish
