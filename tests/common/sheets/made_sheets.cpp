#include "tests/common/sheets/made_sheets.h"

#include "common/sheets/chart_codec.h"
#include "common/sheets/cut_charts.h"
#include "common/sheets/sheet_codec.h"
#include "tests/common/sheets/made_surfaces.h"
#include "tests/common/sheets/made_texture.h"

namespace burnish {

PageHead six_page_head() {
  PageHead head{.scan_vertices = 9, .scan_triangles = 9};
  head.level_pages = {3, 2, 1};
  return head;
}

std::vector<MadeSheets> six_pages() {
  std::vector<MadeSheets> made;
  for (PageId p = 0; p < 6; ++p) {
    MadeSheets& one = made.emplace_back();
    one.page = wavy_page(4 + static_cast<int>(p), 100, 30);
    one.page.id = p;
    one.charts = cut_charts(one.page, 0.1);
    for (uint8_t halving = 0; halving <= p % 3; ++halving) {
      const float density = 0.1f / static_cast<float>(1 << halving);
      one.sheets.push_back(
          baked_sheet(one.page, one.charts, density, pattern_on(one.page, 300), 1));
      one.sheets.back().halving = halving;
    }
  }
  return made;
}

void write_six_pages(const std::filesystem::path& path) {
  SheetFileWriter writer = SheetFileWriter::create(path, kMadeOrigin).value();
  for (const MadeSheets& made : six_pages()) {
    std::vector<std::vector<uint8_t>> sheets;
    for (const Sheet& sheet : made.sheets) sheets.push_back(encode_sheet(sheet).value());
    const Status added = writer.add(encode_charts(made.page.id, made.charts), sheets);
    BURNISH_CHECK(added.is_ok(), added.message());
  }
  const Status finished = writer.finish(six_page_head());
  BURNISH_CHECK(finished.is_ok(), finished.message());
}

}  // namespace burnish
