#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>

#include "common/packing/checksum.h"
#include "common/packing/word_section.h"
#include "common/pages/bounds_checks.h"
#include "common/pages/directory_codec.h"
#include "common/pages/page_format.h"

namespace burnish {

namespace {

static_assert(std::endian::native == std::endian::little, "blocks are written as they lie");

struct RawBlockHeader {
  std::array<char, 4> magic = kPageBlockMagic;
  uint8_t version = kPageFormatVersion;
  std::array<uint8_t, 3> zero8 = {};
  uint32_t begin = 0;
  uint32_t pages = 0;
  uint32_t coarser = 0;
  uint32_t zero32 = 0;
  uint64_t checksum = 0;
};
static_assert(sizeof(RawBlockHeader) == kPageBlockHeaderBytes);

constexpr WordLayout kLayout = {4, 1, 1};
constexpr size_t kColumns = 9;

using Row = std::array<uint32_t, kColumns>;

Row row_of(const PageEntry& entry, size_t coarser) {
  const PageBounds& bounds = entry.bounds;
  const auto bits = [](float value) { return std::bit_cast<uint32_t>(value); };
  return {bits(bounds.centre.x()),
          bits(bounds.centre.y()),
          bits(bounds.centre.z()),
          bits(bounds.radius),
          bits(bounds.error),
          bits(bounds.edge),
          entry.bytes,
          entry.vertices | uint32_t{entry.triangles} << 16,
          static_cast<uint32_t>(coarser)};
}

PageEntry entry_of(const Row& row) {
  const auto value = [&row](size_t column) { return std::bit_cast<float>(row[column]); };
  return {{{value(0), value(1), value(2)}, value(3), value(4), value(5)},
          row[6],
          static_cast<uint16_t>(row[7]),
          static_cast<uint16_t>(row[7] >> 16)};
}

uint64_t checksum_of(std::span<const uint8_t> bytes) {
  return sealed_checksum(bytes, offsetof(RawBlockHeader, checksum), sizeof(RawBlockHeader));
}

Result<RawBlockHeader> read_header(std::span<const uint8_t> bytes, const PageRange& pages) {
  RawBlockHeader raw;
  if (bytes.size() < sizeof(raw))
    return data_loss("it has " + std::to_string(bytes.size()) + " bytes, its header needs " +
                     std::to_string(sizeof(raw)));
  std::memcpy(&raw, bytes.data(), sizeof(raw));
  if (raw.magic != kPageBlockMagic) return data_loss("it does not begin with BnPd");
  if (raw.version != kPageFormatVersion)
    return unimplemented("it has format version " + std::to_string(raw.version) +
                         ", this program reads " + std::to_string(kPageFormatVersion));
  if (raw.checksum != checksum_of(bytes)) return data_loss("its checksum is wrong");
  if (raw.zero8 != std::array<uint8_t, 3>{} || raw.zero32 != 0)
    return data_loss("reserved bits are set");
  RETURN_IF_ERROR(check_page_value("first page", raw.begin, pages.begin, pages.begin));
  RETURN_IF_ERROR(check_page_value("pages", raw.pages, pages.count(), pages.count()));
  RETURN_IF_ERROR(check_page_value("coarser pages", raw.coarser, 0u, kCoarserPerBlockMax));
  return raw;
}

/// Returns the words of the columns and of the coarser pages behind them.
Result<std::vector<uint32_t>> read_words(std::span<const uint8_t> section, size_t count) {
  ASSIGN_OR_RETURN(const auto bytes, unpack_words(kLayout, section, 4 * count));
  std::vector<uint32_t> words(count);
  std::memcpy(words.data(), bytes.data(), bytes.size());
  return words;
}

Status check_entry(const PageEntry& entry, const PageBounds& block) {
  RETURN_IF_ERROR(check_bounds("bounds", entry.bounds));
  RETURN_IF_ERROR(check_page_value("error", entry.bounds.error, 0.0f, block.error));
  RETURN_IF_ERROR(check_page_value("edge", entry.bounds.edge, 0.0f, block.edge));
  RETURN_IF_ERROR(
      check_page_value<uint64_t>("bytes", entry.bytes, kPageHeaderBytes + 1, kPageBytesMax));
  RETURN_IF_ERROR(check_page_value<uint64_t>("vertices", entry.vertices, 1, kPageVerticesMax));
  return check_page_value<uint64_t>("triangles", entry.triangles, 1, kPageTrianglesMax);
}

Status check_coarser(std::span<const PageId> coarser, PageId page, const PageHead& head) {
  if (page == head.root())
    return check_page_value<size_t>("coarser pages of the root", coarser.size(), 0, 0);
  RETURN_IF_ERROR(
      check_page_value<size_t>("coarser pages", coarser.size(), 1, kCoarserPerBlockMax));
  const int level = head.level_of(page);
  PageId least = head.level_begin(level + 1);
  const PageId last = head.level_begin(level + 2) - 1;
  for (const PageId id : coarser) {
    RETURN_IF_ERROR(check_page_value("coarser page", id, least, last));
    least = id + 1;
  }
  return Status::ok();
}

Status check_block(const DirectoryBlock& block, const PageHead& head, uint32_t index) {
  uint64_t bytes = 0;
  for (size_t i = 0; i < block.entries.size(); ++i) {
    const auto page = static_cast<PageId>(block.begin + i);
    const std::string name = "page " + std::to_string(page);
    Status status = check_entry(block.entries[i], head.blocks[index].bounds);
    if (status.is_ok()) status = check_coarser(block.coarser[i], page, head);
    if (!status.is_ok()) return status.with_context(name);
    bytes += block.entries[i].bytes;
  }
  const uint64_t wanted = head.page_end(index) - head.blocks[index].page_begin;
  return check_page_value("bytes of its pages", bytes, wanted, wanted);
}

/// Cuts the words into entries and lists. Fails: data_loss if the lists' lengths do not add up.
Status read_rows(std::span<const uint32_t> words, DirectoryBlock& block) {
  const size_t pages = block.entries.size();
  auto coarser = words.subspan(kColumns * pages);
  for (size_t i = 0; i < pages; ++i) {
    Row row;
    for (size_t column = 0; column < kColumns; ++column) row[column] = words[column * pages + i];
    block.entries[i] = entry_of(row);
    const size_t count = row[kColumns - 1];
    if (count > coarser.size())
      return data_loss("page " + std::to_string(block.begin + i) + " has " + std::to_string(count) +
                       " coarser pages, " + std::to_string(coarser.size()) + " are left");
    block.coarser.add(coarser.first(count));
    coarser = coarser.subspan(count);
  }
  return check_page_value<size_t>("coarser pages that are left", coarser.size(), 0, 0);
}

Result<DirectoryBlock> decode(std::span<const uint8_t> bytes, const PageHead& head,
                              uint32_t index) {
  ASSIGN_OR_RETURN(const RawBlockHeader raw, read_header(bytes, head.pages_of(index)));
  ASSIGN_OR_RETURN(const auto words,
                   read_words(bytes.subspan(sizeof(raw)), kColumns * raw.pages + raw.coarser));
  DirectoryBlock block{.begin = raw.begin, .entries = std::vector<PageEntry>(raw.pages)};
  RETURN_IF_ERROR(read_rows(words, block));
  RETURN_IF_ERROR(check_block(block, head, index));
  return block;
}

}  // namespace

std::vector<uint8_t> encode_block(const DirectoryBlock& block) {
  const size_t pages = block.entries.size();
  BURNISH_CHECK(pages <= kPagesPerBlock && block.coarser.item.size() <= kCoarserPerBlockMax,
                "the block is too large");
  std::vector<uint32_t> words(kColumns * pages);
  for (size_t i = 0; i < pages; ++i) {
    const Row row = row_of(block.entries[i], block.coarser[i].size());
    for (size_t column = 0; column < kColumns; ++column) words[column * pages + i] = row[column];
  }
  words.insert(words.end(), block.coarser.item.begin(), block.coarser.item.end());
  const std::vector<uint8_t> section = pack_words(
      kLayout, {reinterpret_cast<const uint8_t*>(words.data()), words.size() * sizeof(words[0])});

  RawBlockHeader raw{.begin = block.begin,
                     .pages = static_cast<uint32_t>(pages),
                     .coarser = static_cast<uint32_t>(block.coarser.item.size())};
  std::vector<uint8_t> bytes(sizeof(raw) + section.size());
  std::ranges::copy(section, bytes.begin() + sizeof(raw));
  std::memcpy(bytes.data(), &raw, sizeof(raw));
  raw.checksum = checksum_of(bytes);
  std::memcpy(bytes.data(), &raw, sizeof(raw));
  return bytes;
}

Result<DirectoryBlock> decode_block(std::span<const uint8_t> bytes, const PageHead& head,
                                    uint32_t index) {
  auto block = decode(bytes, head, index);
  if (!block.is_ok())
    return block.status().with_context("block " + std::to_string(index) + " of pages");
  return block;
}

}  // namespace burnish
