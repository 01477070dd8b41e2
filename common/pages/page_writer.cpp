#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>

#include "common/pages/directory_codec.h"
#include "common/pages/page_file.h"
#include "common/pages/page_format.h"

namespace burnish {

PageFileWriter::PageFileWriter(AtomicFile file, const PageScan& scan) : file_(std::move(file)) {
  directory_.head = {.grid = scan.grid,
                     .has_colours = scan.has_colours,
                     .scan_vertices = scan.vertices,
                     .scan_triangles = scan.triangles};
}

Result<PageFileWriter> PageFileWriter::create(const std::filesystem::path& path,
                                              const PageScan& scan) {
  ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::create(path));
  return PageFileWriter(std::move(file), scan);
}

void PageFileWriter::begin_level() {
  BURNISH_CHECK(directory_.head.level_pages.size() < kPageLevelsMax, "too many levels of pages");
  directory_.head.level_pages.push_back(0);
}

Status PageFileWriter::add(const Page& page, const PageBounds& bounds,
                           std::span<const uint8_t> encoded) {
  BURNISH_CHECK(page.id == next_page(), "pages come in the order of their numbers");
  if (page.id == kPagesMax)
    return resource_exhausted("the scan has more than " + std::to_string(kPagesMax) + " pages");
  PageHead& head = directory_.head;
  ++head.level_pages.back();
  head.page_bytes += encoded.size();
  directory_.entries.push_back({bounds, static_cast<uint32_t>(encoded.size()),
                                static_cast<uint16_t>(page.positions.size()),
                                static_cast<uint16_t>(page.triangles.size())});
  for (const PagePatch& patch : page.patches) {
    if (patch.finer == kNoPage) continue;
    const PageBounds& finer = directory_.entries.at(patch.finer).bounds;
    BURNISH_CHECK(finer.error <= bounds.error && finer.edge <= bounds.edge,
                  "error and edge of a coarser page are not below a finer one's");
    links_.push_back({patch.finer, page.id});
  }
  return file_.write(encoded);
}

void PageFileWriter::gather_coarser() {
  // Pages come in order, so a finer page's coarser pages come rising.
  directory_.coarser = group_by<PageId>(directory_.entries.size(), [this](auto&& add_one) {
    for (const Link& link : links_) add_one(link.finer, link.coarser);
  });
  for (PageId page = 0; page < directory_.head.root(); ++page)
    BURNISH_CHECK(!directory_.coarser[page].empty(), "every page but the root has coarser pages");
}

Status PageFileWriter::write_blocks() {
  PageHead& head = directory_.head;
  uint64_t page_begin = 0;
  const uint32_t blocks = head.block_count();
  for (uint32_t b = 0; b < blocks; ++b) {
    const PageRange pages = head.pages_of(b);
    const auto entries = std::span(directory_.entries).subspan(pages.begin, pages.count());
    DirectoryBlock block{.begin = pages.begin, .entries = {entries.begin(), entries.end()}};
    for (PageId page = pages.begin; page < pages.end; ++page)
      block.coarser.add(directory_.coarser[page]);
    if (block.coarser.item.size() > kCoarserPerBlockMax)
      return resource_exhausted("block " + std::to_string(b) + " of pages has " +
                                std::to_string(block.coarser.item.size()) +
                                " coarser pages, the limit is " +
                                std::to_string(kCoarserPerBlockMax));
    const std::vector<uint8_t> bytes = encode_block(block);
    head.blocks.push_back({join_bounds(entries), page_begin, static_cast<uint32_t>(bytes.size())});
    head.block_bytes += bytes.size();
    for (const PageEntry& entry : entries) page_begin += entry.bytes;
    RETURN_IF_ERROR(file_.write(bytes));
  }
  return Status::ok();
}

Status PageFileWriter::finish() {
  PageHead& head = directory_.head;
  BURNISH_CHECK(!head.level_pages.empty() && head.level_pages.back() == 1,
                "the last level has one page");
  gather_coarser();
  RETURN_IF_ERROR(write_blocks());
  std::vector<uint8_t> bytes = encode_head(head);
  const PageTail tail{.head_bytes = static_cast<uint32_t>(bytes.size())};
  const auto* begin = reinterpret_cast<const uint8_t*>(&tail);
  bytes.insert(bytes.end(), begin, begin + sizeof(tail));
  RETURN_IF_ERROR(file_.write(bytes));
  return file_.commit();
}

}  // namespace burnish
