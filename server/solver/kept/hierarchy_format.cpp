#include "server/solver/kept/hierarchy_format.h"

#include <cstddef>
#include <string>
#include <xxhash.h>

#include "server/solver/hierarchy/hierarchy.h"
#include "server/solver/kept/hierarchy_file.h"

namespace burnish {

namespace {

Status check_equal(const std::string& what, int64_t value, int64_t wanted) {
  if (value == wanted) return Status::ok();
  return data_loss(what + " is " + std::to_string(value) + ", must be " + std::to_string(wanted));
}

Status check_range(const std::string& what, int64_t value, int64_t least, int64_t most) {
  if (value >= least && value <= most) return Status::ok();
  return data_loss(what + " is " + std::to_string(value) + ", must be in " + std::to_string(least) +
                   ".." + std::to_string(most));
}

// Needs: the entry's element size is right.
Status check_entry(const SectionEntry& entry, uint64_t& end, uint64_t file_bytes) {
  const uint64_t offset = align_section(end);
  if (entry.offset != offset || offset > file_bytes)
    return data_loss("offset is " + std::to_string(entry.offset) + " in a file of " +
                     std::to_string(file_bytes));
  const uint64_t room = (file_bytes - offset) / entry.element_bytes;
  if (entry.count > room)
    return data_loss("count is " + std::to_string(entry.count) + ", the file has room for " +
                     std::to_string(room));
  end = offset + entry.count * entry.element_bytes;
  return Status::ok();
}

}  // namespace

uint64_t hierarchy_checksum(const HierarchyHeader& header, std::span<const SectionEntry> table) {
  const uint64_t of_header = XXH3_64bits(&header, offsetof(HierarchyHeader, checksum));
  return XXH3_64bits_withSeed(table.data(), table.size_bytes(), of_header);
}

Status check_hierarchy_header(const HierarchyHeader& header, uint64_t fingerprint, int depth,
                              uint64_t file_bytes) {
  if (header.magic != kHierarchyMagic) return data_loss("header: this is not a hierarchy");
  RETURN_IF_ERROR(check_equal("header: format version", header.version, kHierarchyFormatVersion));
  if (header.fingerprint != fingerprint)
    return data_loss("header: it was made from another prepared mesh, or by another release");
  RETURN_IF_ERROR(check_equal("header: finest depth", header.finest, depth));
  RETURN_IF_ERROR(check_range("header: coarsest depth", header.coarsest, kCoarsestDepthMin, depth));
  RETURN_IF_ERROR(check_range("header: flat parts", header.has_flat_parts, 0, 1));
  RETURN_IF_ERROR(check_range("header: sheets", header.sheet_count, 0, INT32_MAX));
  RETURN_IF_ERROR(check_equal("header: number of sections",
                              static_cast<int64_t>(header.section_count),
                              static_cast<int64_t>(section_count(header.coarsest, depth))));
  return check_equal("length of the file", static_cast<int64_t>(file_bytes),
                     static_cast<int64_t>(header.file_bytes));
}

Status check_hierarchy_table(const HierarchyHeader& header, std::span<const SectionEntry> table,
                             std::span<const uint32_t> element_bytes) {
  if (hierarchy_checksum(header, table) != header.checksum)
    return data_loss("header: its checksum is wrong");
  uint64_t end = sizeof(header) + table.size_bytes();
  for (size_t i = 0; i < table.size(); ++i) {
    const SectionEntry& entry = table[i];
    const std::string where = "section " + std::to_string(i) + ": ";
    RETURN_IF_ERROR(check_equal(where + "id", entry.id, static_cast<int64_t>(i)));
    RETURN_IF_ERROR(check_equal(where + "element size", entry.element_bytes, element_bytes[i]));
    const Status fits = check_entry(entry, end, header.file_bytes);
    if (!fits.is_ok()) return fits.with_context("section " + std::to_string(i));
  }
  return check_equal("the end of the last section", static_cast<int64_t>(end),
                     static_cast<int64_t>(header.file_bytes));
}

}  // namespace burnish
