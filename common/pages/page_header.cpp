#include "common/pages/page_header.h"

#include <bit>
#include <cstring>
#include <string>

#include "common/base/limits.h"
#include "common/packing/checksum.h"

namespace burnish {

namespace {

static_assert(std::endian::native == std::endian::little, "pages are written as they lie");

size_t bytes_of_bits(size_t bits) {
  return (bits + 7) / 8;
}

uint64_t checksum_of(std::span<const uint8_t> bytes) {
  return sealed_checksum(bytes, offsetof(PageHeader, checksum), sizeof(PageHeader));
}

Status check_value(const char* name, uint64_t value, uint64_t least, uint64_t most) {
  if (value >= least && value <= most) return Status::ok();
  return data_loss(std::to_string(value) + " " + name + " are outside " + std::to_string(least) +
                   ".." + std::to_string(most));
}

Status check_counts(const PageHeader& header) {
  RETURN_IF_ERROR(check_value("vertices", header.vertices, 1, kPageVerticesMax));
  RETURN_IF_ERROR(check_value("triangles", header.triangles, 1, kPageTrianglesMax));
  RETURN_IF_ERROR(check_value("border vertices", header.border_vertices, 0, header.vertices));
  RETURN_IF_ERROR(check_value("patches", header.patches, 1, header.triangles));
  RETURN_IF_ERROR(check_value("bytes of a coordinate", header.place_bytes, 0, 4));
  RETURN_IF_ERROR(check_value("flags", header.flags, 0, 3));
  return check_value("reserved bits", header.zero8 | header.zero16, 0, 0);
}

}  // namespace

std::array<size_t, kPageSections> section_bytes(const PageHeader& header) {
  const size_t vertices = header.vertices;
  return {size_t{4} * header.patches,
          bytes_of_bits(size_t{4} * header.steps),
          size_t{2} * header.named_vertices,
          header.patches > 1 ? bytes_of_bits(header.triangles) : 0,
          size_t{2} * header.named_patches,
          bytes_of_bits(vertices),
          3 * header.place_bytes * vertices,
          2 * (header.has_all_normals() ? vertices : header.border_vertices),
          header.has_colours() ? 4 * vertices : 0};
}

Result<PageHeader> read_page_header(std::span<const uint8_t> bytes) {
  PageHeader header;
  if (bytes.size() < sizeof(header))
    return data_loss("the page has " + std::to_string(bytes.size()) + " bytes, its header needs " +
                     std::to_string(sizeof(header)));
  std::memcpy(&header, bytes.data(), sizeof(header));
  if (header.magic != kPageMagic) return data_loss("the page does not begin with BnPg");
  if (header.version != kPageFormatVersion)
    return unimplemented("the page has format version " + std::to_string(header.version) +
                         ", this program reads " + std::to_string(kPageFormatVersion));
  const std::string name = "page " + std::to_string(header.id);
  if (header.checksum != checksum_of(bytes)) return data_loss(name + ": its checksum is wrong");
  const Status counts = check_counts(header);
  if (!counts.is_ok()) return counts.with_context(name);
  return header;
}

void seal_page(PageHeader header, std::span<uint8_t> bytes) {
  std::memcpy(bytes.data(), &header, sizeof(header));
  header.checksum = checksum_of(bytes);
  std::memcpy(bytes.data(), &header, sizeof(header));
}

}  // namespace burnish
