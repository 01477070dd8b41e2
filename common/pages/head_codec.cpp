#include <array>
#include <bit>
#include <cstring>
#include <string>

#include "common/base/check.h"
#include "common/base/limits.h"
#include "common/packing/checksum.h"
#include "common/pages/bounds_checks.h"
#include "common/pages/directory_codec.h"
#include "common/pages/page_format.h"

namespace burnish {

namespace {

static_assert(std::endian::native == std::endian::little, "heads are written as they lie");

struct RawHead {
  std::array<char, 4> magic = kPageHeadMagic;
  uint8_t version = kPageFormatVersion;
  uint8_t bits = 0;
  uint8_t levels = 0;
  uint8_t has_colours = 0;
  std::array<double, 3> origin = {};
  double side = 0;
  uint64_t scan_vertices = 0;
  uint64_t scan_triangles = 0;
  uint64_t page_bytes = 0;
  uint64_t block_bytes = 0;
  uint64_t checksum = 0;
};
static_assert(sizeof(RawHead) == kPageHeadHeaderBytes);

struct RawBlock {
  std::array<float, 3> centre;
  float radius;
  float error;
  float edge;
  uint32_t bytes;
  uint32_t zero;
  uint64_t page_begin;
};
static_assert(sizeof(RawBlock) == 40);

uint64_t checksum_of(std::span<const uint8_t> bytes) {
  return sealed_checksum(bytes, offsetof(RawHead, checksum), sizeof(RawHead));
}

template <typename T>
void append_raw(const T& raw, std::vector<uint8_t>& bytes) {
  bytes.resize(bytes.size() + sizeof(raw));
  std::memcpy(bytes.data() + bytes.size() - sizeof(raw), &raw, sizeof(raw));
}

template <typename T>
T raw_at(std::span<const uint8_t> bytes, size_t offset) {
  T raw;
  std::memcpy(&raw, bytes.data() + offset, sizeof(raw));
  return raw;
}

RawBlock raw_of(const PageBlock& block) {
  const PageBounds& bounds = block.bounds;
  return {{bounds.centre.x(), bounds.centre.y(), bounds.centre.z()},
          bounds.radius,
          bounds.error,
          bounds.edge,
          block.bytes,
          0,
          block.page_begin};
}

PageBlock block_of(const RawBlock& raw) {
  return {{{raw.centre[0], raw.centre[1], raw.centre[2]}, raw.radius, raw.error, raw.edge},
          raw.page_begin,
          raw.bytes};
}

Status check_beginning(std::span<const uint8_t> bytes) {
  if (bytes.size() < sizeof(RawHead))
    return data_loss("it has " + std::to_string(bytes.size()) + " bytes, its header needs " +
                     std::to_string(sizeof(RawHead)));
  const auto raw = raw_at<RawHead>(bytes, 0);
  if (raw.magic != kPageHeadMagic) return data_loss("it does not begin with BnPh");
  if (raw.version != kPageFormatVersion)
    return unimplemented("it has format version " + std::to_string(raw.version) +
                         ", this program reads " + std::to_string(kPageFormatVersion));
  if (raw.checksum != checksum_of(bytes)) return data_loss("its checksum is wrong");
  return Status::ok();
}

Status check_scalars(const RawHead& raw) {
  // Side of a cube around coordinates of the largest size.
  constexpr double kReach = 4 * kCoordinateMagnitudeMax;
  RETURN_IF_ERROR(check_page_value<int>("bits", raw.bits, 1, kPageGridBitsMax));
  RETURN_IF_ERROR(check_page_value<int>("levels", raw.levels, 1, kPageLevelsMax));
  RETURN_IF_ERROR(check_page_value<int>("colours", raw.has_colours, 0, 1));
  for (const double origin : raw.origin)
    RETURN_IF_ERROR(check_page_value("origin", origin, -kReach, kReach));
  RETURN_IF_ERROR(check_page_value("side", raw.side, std::numeric_limits<double>::min(), kReach));
  RETURN_IF_ERROR(check_page_value("vertices", raw.scan_vertices, uint64_t{1}, kVerticesMax));
  return check_page_value("triangles", raw.scan_triangles, uint64_t{1}, kTrianglesMax);
}

PageHead head_of(const RawHead& raw) {
  return {.grid = {{raw.origin[0], raw.origin[1], raw.origin[2]}, raw.side, raw.bits},
          .has_colours = raw.has_colours != 0,
          .scan_vertices = raw.scan_vertices,
          .scan_triangles = raw.scan_triangles,
          .page_bytes = raw.page_bytes,
          .block_bytes = raw.block_bytes};
}

Status read_levels(std::span<const uint8_t> bytes, int levels, PageHead& head) {
  uint64_t pages = 0;
  for (int level = 0; level < levels; ++level) {
    head.level_pages.push_back(raw_at<uint32_t>(bytes, sizeof(RawHead) + 4 * level));
    const uint32_t count = head.level_pages.back();
    const uint32_t most = level + 1 == levels ? 1 : kPagesMax;
    RETURN_IF_ERROR(check_page_value("pages of level " + std::to_string(level), count, 1u, most));
    pages += count;
  }
  return check_page_value<uint64_t>("pages", pages, 1, kPagesMax);
}

/// Checks that pages and blocks fill their parts of the file without gaps.
Status check_blocks(const PageHead& head) {
  uint64_t block_bytes = 0;
  for (uint32_t b = 0; b < head.blocks.size(); ++b) {
    const std::string name = "block " + std::to_string(b);
    RETURN_IF_ERROR(check_bounds(name, head.blocks[b].bounds));
    const uint64_t begin = head.blocks[b].page_begin;
    if (b == 0) RETURN_IF_ERROR(check_page_value<uint64_t>(name + ": begin", begin, 0, 0));
    const uint64_t end = head.page_end(b);
    const uint64_t most = uint64_t{kPageBytesMax} * head.pages_of(b).count();
    if (end <= begin || end - begin > most)
      return data_loss(name + ": its pages lie at " + std::to_string(begin) + ".." +
                       std::to_string(end) + ", the limit is " + std::to_string(most) + " bytes");
    block_bytes += head.blocks[b].bytes;
  }
  return check_page_value("bytes of all blocks", block_bytes, head.block_bytes, head.block_bytes);
}

Result<PageHead> decode(std::span<const uint8_t> bytes) {
  RETURN_IF_ERROR(check_beginning(bytes));
  const auto raw = raw_at<RawHead>(bytes, 0);
  RETURN_IF_ERROR(check_scalars(raw));
  PageHead head = head_of(raw);
  const size_t table = sizeof(RawHead) + size_t{4} * raw.levels;
  if (bytes.size() < table)
    return data_loss("it has " + std::to_string(bytes.size()) + " bytes, its levels need " +
                     std::to_string(table));
  RETURN_IF_ERROR(read_levels(bytes, raw.levels, head));
  const uint32_t blocks = head.block_count();
  const size_t size = table + blocks * sizeof(RawBlock);
  if (bytes.size() != size)
    return data_loss("it has " + std::to_string(bytes.size()) + " bytes, " +
                     std::to_string(blocks) + " blocks need " + std::to_string(size));
  for (uint32_t b = 0; b < blocks; ++b) {
    const auto block = raw_at<RawBlock>(bytes, table + b * sizeof(RawBlock));
    if (block.zero != 0) return data_loss("block " + std::to_string(b) + ": reserved bits are set");
    head.blocks.push_back(block_of(block));
  }
  RETURN_IF_ERROR(check_blocks(head));
  return head;
}

}  // namespace

std::vector<uint8_t> encode_head(const PageHead& head) {
  RawHead raw{.bits = static_cast<uint8_t>(head.grid.bits),
              .levels = static_cast<uint8_t>(head.level_pages.size()),
              .has_colours = head.has_colours ? uint8_t{1} : uint8_t{0},
              .side = head.grid.side,
              .scan_vertices = head.scan_vertices,
              .scan_triangles = head.scan_triangles,
              .page_bytes = head.page_bytes,
              .block_bytes = head.block_bytes};
  for (int axis = 0; axis < 3; ++axis) raw.origin[axis] = head.grid.origin[axis];
  std::vector<uint8_t> bytes;
  append_raw(raw, bytes);
  for (const uint32_t pages : head.level_pages) append_raw(pages, bytes);
  for (const PageBlock& block : head.blocks) append_raw(raw_of(block), bytes);
  raw.checksum = checksum_of(bytes);
  std::memcpy(bytes.data(), &raw, sizeof(raw));
  return bytes;
}

Result<PageHead> decode_head(std::span<const uint8_t> bytes) {
  auto head = decode(bytes);
  if (!head.is_ok()) return head.status().with_context("head of pages");
  return head;
}

uint64_t pages_fingerprint(std::span<const uint8_t> encoded_head) {
  BURNISH_CHECK(encoded_head.size() >= sizeof(RawHead), "a fingerprint needs an encoded head");
  RawHead raw;
  std::memcpy(&raw, encoded_head.data(), sizeof raw);
  return raw.checksum;
}

}  // namespace burnish
