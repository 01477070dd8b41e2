#include "common/view/view_format.h"

#include <bit>
#include <cstring>

#include "common/packing/checksum.h"
#include "common/packing/word_section.h"

namespace burnish {

namespace {

static_assert(std::endian::native == std::endian::little, "views are written as they lie");

struct RawHeader {
  std::array<char, 4> magic;
  uint8_t version;
  uint8_t depth;
  uint16_t zero;
  std::array<double, 3> origin;
  double cell_size;
  double length_unit;
  uint64_t scan_vertices;
  uint64_t scan_triangles;
  std::array<uint64_t, kViewSections> elements;
  std::array<uint64_t, kViewSections> section_bytes;
  uint64_t checksum;
};
static_assert(sizeof(RawHeader) == kViewHeaderBytes);

constexpr std::array<char, 4> kMagic = {'B', 'n', 'V', 'w'};
constexpr std::array<WordLayout, kViewSections> kLayouts = {
    {{8, 1, 1}, {4, 3, 3}, {4, 1, 1}, {4, 0, 3}, {8, 0, 3}, {4, 0, 1}}};
constexpr std::array<const char*, kViewSections> kNames = {"cells",  "triangles", "homes",
                                                           "locals", "strays",    "colours"};

// Memory of an element while the view is read and after: a cell with its corners and their
// neighbours, a vertex's position and point, and the sections themselves.
constexpr std::array<uint64_t, kViewSections> kElementMemoryBytes = {600, 36, 52, 24, 48, 8};

constexpr uint64_t kSectionElementsMax = kVerticesMax;

uint64_t checksum_of(std::span<const uint8_t> bytes) {
  return sealed_checksum(bytes, offsetof(RawHeader, checksum), kViewHeaderBytes);
}

size_t element_bytes(const WordLayout& layout) {
  return layout.word_bytes * layout.words_of_element;
}

template <typename T>
std::span<const uint8_t> bytes_of(const std::vector<T>& elements) {
  return {reinterpret_cast<const uint8_t*>(elements.data()), elements.size() * sizeof(T)};
}

Status check_header(const RawHeader& raw, std::span<const uint8_t> bytes,
                    uint64_t memory_bytes_max) {
  if (raw.magic != kMagic) return data_loss("the view does not begin with BnVw");
  if (raw.version != kViewFormatVersion)
    return unimplemented("the view has format version " + std::to_string(raw.version) +
                         ", this program reads " + std::to_string(kViewFormatVersion));
  if (raw.checksum != checksum_of(bytes)) return data_loss("view: its checksum is wrong");
  uint64_t body_left = bytes.size() - kViewHeaderBytes;
  uint64_t memory_bytes = 0;
  for (size_t s = 0; s < kViewSections; ++s) {
    const std::string section = std::string("view: section ") + kNames[s];
    if (raw.elements[s] > kSectionElementsMax)
      return data_loss(section + " has " + std::to_string(raw.elements[s]) +
                       " elements, the limit is " + std::to_string(kSectionElementsMax));
    if (raw.section_bytes[s] > body_left)
      return data_loss(section + " has " + std::to_string(raw.section_bytes[s]) + " bytes, " +
                       std::to_string(body_left) + " are left");
    body_left -= raw.section_bytes[s];
    memory_bytes += raw.elements[s] * kElementMemoryBytes[s];
  }
  if (body_left != 0)
    return data_loss("view: " + std::to_string(body_left) + " bytes follow the last section");
  if (memory_bytes > memory_bytes_max)
    return resource_exhausted("the view takes " + std::to_string(memory_bytes) +
                              " bytes of memory, the limit is " + std::to_string(memory_bytes_max));
  return Status::ok();
}

/// Reads the sections of a file, one after the other.
class SectionReader {
 public:
  SectionReader(const RawHeader& header, std::span<const uint8_t> body)
      : header_(header), body_(body) {}

  template <typename T>
  Status read(std::vector<T>& elements) {
    const auto section = body_.first(header_.section_bytes[next_]);
    const uint64_t size = header_.elements[next_] * sizeof(T);
    auto words = unpack_words(kLayouts[next_], section, size);
    if (!words.is_ok())
      return words.status().with_context(std::string("view: section ") + kNames[next_]);
    elements.resize(header_.elements[next_]);
    if (size > 0) std::memcpy(elements.data(), words->data(), size);
    body_ = body_.subspan(section.size());
    ++next_;
    return Status::ok();
  }

 private:
  const RawHeader& header_;
  std::span<const uint8_t> body_;
  size_t next_ = 0;
};

}  // namespace

std::vector<uint8_t> pack_view(const ViewParts& parts) {
  RawHeader raw = {.magic = kMagic,
                   .version = kViewFormatVersion,
                   .depth = static_cast<uint8_t>(parts.frame.depth),
                   .cell_size = parts.frame.cell_size,
                   .length_unit = parts.length_unit,
                   .scan_vertices = parts.scan_vertices,
                   .scan_triangles = parts.scan_triangles};
  for (int axis = 0; axis < 3; ++axis) raw.origin[axis] = parts.frame.origin[axis];
  std::vector<uint8_t> bytes(kViewHeaderBytes);
  const std::array<std::span<const uint8_t>, kViewSections> sections = {
      bytes_of(parts.cells),  bytes_of(parts.triangles), bytes_of(parts.homes),
      bytes_of(parts.locals), bytes_of(parts.strays),    bytes_of(parts.colours)};
  for (size_t s = 0; s < kViewSections; ++s) {
    const std::vector<uint8_t> packed = pack_words(kLayouts[s], sections[s]);
    raw.elements[s] = sections[s].size() / element_bytes(kLayouts[s]);
    raw.section_bytes[s] = packed.size();
    bytes.insert(bytes.end(), packed.begin(), packed.end());
  }
  std::memcpy(bytes.data(), &raw, sizeof(raw));
  raw.checksum = checksum_of(bytes);
  std::memcpy(bytes.data(), &raw, sizeof(raw));
  return bytes;
}

Result<ViewParts> unpack_view(std::span<const uint8_t> bytes, uint64_t memory_bytes_max) {
  RawHeader raw;
  if (bytes.size() < sizeof(raw))
    return data_loss("the view has " + std::to_string(bytes.size()) + " bytes, its header needs " +
                     std::to_string(sizeof(raw)));
  std::memcpy(&raw, bytes.data(), sizeof(raw));
  RETURN_IF_ERROR(check_header(raw, bytes, memory_bytes_max));
  ViewParts parts;
  parts.frame = {{raw.origin[0], raw.origin[1], raw.origin[2]}, raw.cell_size, raw.depth};
  parts.length_unit = raw.length_unit;
  parts.scan_vertices = raw.scan_vertices;
  parts.scan_triangles = raw.scan_triangles;
  SectionReader sections(raw, bytes.subspan(kViewHeaderBytes));
  RETURN_IF_ERROR(sections.read(parts.cells));
  RETURN_IF_ERROR(sections.read(parts.triangles));
  RETURN_IF_ERROR(sections.read(parts.homes));
  RETURN_IF_ERROR(sections.read(parts.locals));
  RETURN_IF_ERROR(sections.read(parts.strays));
  RETURN_IF_ERROR(sections.read(parts.colours));
  return parts;
}

}  // namespace burnish
