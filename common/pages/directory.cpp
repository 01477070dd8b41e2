#include "common/pages/directory.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>

namespace burnish {

namespace {

uint32_t blocks_of(uint32_t pages) {
  return (pages + kPagesPerBlock - 1) / kPagesPerBlock;
}

/// Returns the pages of the next finer level; none for a page of level 0.
PageRange finer_of(PageId page, const PageHead& head) {
  const int level = head.level_of(page);
  if (level == 0) return {};
  return {head.level_begin(level - 1), head.level_begin(level)};
}

}  // namespace

uint32_t PageHead::page_count() const {
  return level_begin(level_count());
}

PageId PageHead::level_begin(int level) const {
  return std::accumulate(level_pages.begin(), level_pages.begin() + level, PageId{0});
}

int PageHead::level_of(PageId page) const {
  int level = 0;
  for (PageId end = level_pages[0]; page >= end; end += level_pages[level]) ++level;
  return level;
}

uint32_t PageHead::block_count() const {
  uint32_t count = 0;
  for (const uint32_t pages : level_pages) count += blocks_of(pages);
  return count;
}

uint32_t PageHead::block_of(PageId page) const {
  uint32_t block = 0;
  for (const uint32_t pages : level_pages) {
    if (page < pages) return block + page / kPagesPerBlock;
    page -= pages;
    block += blocks_of(pages);
  }
  return block;
}

PageRange PageHead::pages_of(uint32_t block) const {
  PageId begin = 0;
  for (const uint32_t pages : level_pages) {
    if (block < blocks_of(pages)) {
      const PageId first = block * kPagesPerBlock;
      return {begin + first, begin + std::min(first + kPagesPerBlock, pages)};
    }
    begin += pages;
    block -= blocks_of(pages);
  }
  return {begin, begin};
}

uint64_t PageHead::page_end(uint32_t block) const {
  return block + 1 < blocks.size() ? blocks[block + 1].page_begin : page_bytes;
}

PageBounds join_bounds(std::span<const PageEntry> entries) {
  Vec3f least = Vec3f::Constant(std::numeric_limits<float>::max());
  Vec3f most = -least;
  PageBounds joined;
  for (const PageEntry& entry : entries) {
    const Vec3f reach = Vec3f::Constant(entry.bounds.radius);
    least = least.cwiseMin(entry.bounds.centre - reach);
    most = most.cwiseMax(entry.bounds.centre + reach);
    joined.error = std::max(joined.error, entry.bounds.error);
    joined.edge = std::max(joined.edge, entry.bounds.edge);
  }
  joined.centre = (least + most) / 2;
  for (const PageEntry& entry : entries) {
    const float distance = (entry.bounds.centre - joined.centre).norm();
    joined.radius = std::max(joined.radius, distance + entry.bounds.radius);
  }
  joined.radius *= 1 + 1e-6f;  // the sums above are rounded
  return joined;
}

Status check_page_in_scan(const Page& page, PageId id, const PageHead& head) {
  const std::string name = "page " + std::to_string(id);
  if (page.id != id)
    return data_loss(name + ": the bytes are those of page " + std::to_string(page.id));
  for (const Vec3i& position : page.positions)
    if (position.maxCoeff() >= head.grid.steps())
      return data_loss(name + ": a vertex lies at " + std::to_string(position.maxCoeff()) +
                       ", the end is " + std::to_string(head.grid.steps()));
  if (page.colours.empty() == head.has_colours)
    return data_loss(name + (head.has_colours ? " has no colours, its scan has"
                                              : " has colours, its scan has not"));
  const PageRange finer = finer_of(id, head);
  for (const PagePatch& patch : page.patches) {
    const bool is_right = finer.count() == 0
                              ? patch.finer == kNoPage
                              : patch.finer >= finer.begin && patch.finer < finer.end;
    if (!is_right)
      return data_loss(name + ": a patch replaces page " + std::to_string(patch.finer) +
                       ", the next finer level is " + std::to_string(finer.begin) + ".." +
                       std::to_string(finer.end));
  }
  return Status::ok();
}

Status check_page_in_directory(const Page& page, PageId id, const PageDirectory& directory) {
  RETURN_IF_ERROR(check_page_in_scan(page, id, directory.head));
  const std::string name = "page " + std::to_string(id);
  const PageEntry& entry = directory.entries[id];
  if (page.positions.size() != entry.vertices || page.triangles.size() != entry.triangles)
    return data_loss(name + " has " + std::to_string(page.positions.size()) + " vertices and " +
                     std::to_string(page.triangles.size()) + " triangles, its entry says " +
                     std::to_string(entry.vertices) + " and " + std::to_string(entry.triangles));
  for (const PagePatch& patch : page.patches)
    if (patch.finer != kNoPage && !std::ranges::binary_search(directory.coarser[patch.finer], id))
      return data_loss(name + " is not among the coarser pages of " + std::to_string(patch.finer) +
                       ", which its patch replaces");
  return Status::ok();
}

}  // namespace burnish
