#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "server/solver/kept/hierarchy_format.h"

namespace burnish {

/// Returns the header of a file that has one.
inline HierarchyHeader header_of_file(std::span<const uint8_t> file) {
  HierarchyHeader header;
  std::memcpy(&header, file.data(), sizeof header);
  return header;
}

/// Returns the part of the table that lies within the file.
inline std::vector<SectionEntry> table_of_file(std::span<const uint8_t> file) {
  const size_t room = (file.size() - sizeof(HierarchyHeader)) / sizeof(SectionEntry);
  const size_t sections = std::min<uint64_t>(header_of_file(file).section_count, room);
  std::vector<SectionEntry> table(sections);
  std::memcpy(table.data(), file.data() + sizeof(HierarchyHeader), sections * sizeof(SectionEntry));
  return table;
}

/// Corrects the checksums of the sections that lie within the file, and the header's.
inline void seal_hierarchy(std::span<uint8_t> file) {
  if (file.size() < sizeof(HierarchyHeader) + sizeof(SectionEntry)) return;
  HierarchyHeader header = header_of_file(file);
  if (header.section_count == 0) return;
  std::vector<SectionEntry> table = table_of_file(file);
  for (SectionEntry& section : table) {
    const uint64_t size = section.count * section.element_bytes;
    const bool is_inside = section.offset <= file.size() && size <= file.size() - section.offset;
    if (is_inside) section.checksum = prepared_checksum(file.subspan(section.offset, size));
  }
  header.checksum = hierarchy_checksum(header, table);
  std::memcpy(file.data(), &header, sizeof header);
  std::memcpy(file.data() + sizeof header, table.data(), table.size() * sizeof(SectionEntry));
}

}  // namespace burnish
