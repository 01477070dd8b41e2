#include "tests/common/pages/made_scan.h"

#include <gtest/gtest.h>

#include "common/pages/directory_codec.h"
#include "common/pages/page_codec.h"
#include "tests/common/pages/made_pages.h"

namespace burnish {

namespace {

constexpr std::array<uint32_t, 3> kLevelPages = {2, 2, 1};

PageBounds bounds_of(int level, PageId page) {
  const auto place = static_cast<float>(page);
  return {{place, 2 * place, 0.5f}, 1.5f, static_cast<float>(level), 2.0f * (level + 1)};
}

}  // namespace

PageDirectory made_directory() {
  PageDirectory directory;
  PageHead& head = directory.head;
  head = {.grid = {{1, 2, 3}, 64, 16}, .scan_vertices = 700, .scan_triangles = 900};
  head.level_pages = {300, 2, 1};
  for (PageId page = 0; page < head.page_count(); ++page) {
    directory.entries.push_back({bounds_of(head.level_of(page), page), 100, 20, 30});
    const std::vector<PageId> coarser = page < 300   ? std::vector<PageId>{300, 301}
                                        : page < 302 ? std::vector<PageId>{302}
                                                     : std::vector<PageId>{};
    directory.coarser.add(coarser);
  }
  for (uint32_t b = 0; b < head.block_count(); ++b) {
    const PageRange pages = head.pages_of(b);
    head.blocks.push_back(
        {join_bounds(std::span(directory.entries).subspan(pages.begin, pages.count())),
         100 * uint64_t{pages.begin}, 80});
  }
  head.page_bytes = 100 * uint64_t{head.page_count()};
  head.block_bytes = 80 * uint64_t{head.block_count()};
  return directory;
}

std::vector<Page> made_scan_pages() {
  std::vector<Page> pages;
  for (PageId id = 0; id < 5; ++id) {
    Page page = made_sheet({.id = id, .columns = 4, .rows = 3, .patches = 0}, id);
    const auto triangles = static_cast<uint32_t>(page.triangles.size());
    if (id >= 2) {
      const PageId finer = id < 4 ? 0 : 2;
      page.patches = {{finer, triangles - 2}, {finer + 1, 2}};
    }
    pages.push_back(std::move(page));
  }
  return pages;
}

PageScan made_scan() {
  return {.grid = {{-1, -2, -3}, 64, 16}, .has_colours = true, .vertices = 24, .triangles = 24};
}

void write_made_scan(const std::filesystem::path& path) {
  auto writer = PageFileWriter::create(path, made_scan());
  ASSERT_TRUE(writer.is_ok()) << writer.status().message();
  const std::vector<Page> pages = made_scan_pages();
  for (int level = 0; level < 3; ++level) {
    writer->begin_level();
    for (uint32_t i = 0; i < kLevelPages[level]; ++i) {
      const Page& page = pages[writer->next_page()];
      ASSERT_TRUE(writer->add(page, bounds_of(level, page.id), encode_page(page)).is_ok());
    }
  }
  const Status finished = writer->finish();
  ASSERT_TRUE(finished.is_ok()) << finished.message();
}

}  // namespace burnish
