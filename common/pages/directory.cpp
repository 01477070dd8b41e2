#include "common/pages/directory.h"

#include <algorithm>
#include <numeric>
#include <string>

namespace burnish {

namespace {

uint32_t blocks_of(uint32_t pages) {
  return (pages + kPagesPerBlock - 1) / kPagesPerBlock;
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
  uint32_t blocks = 0;
  for (const uint32_t pages : level_pages) blocks += blocks_of(pages);
  return blocks;
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

}  // namespace burnish
