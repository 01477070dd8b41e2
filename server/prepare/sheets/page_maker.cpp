#include "server/prepare/sheets/page_maker.h"

#include <utility>

#include "common/sheets/chart_codec.h"
#include "common/sheets/sheet_codec.h"
#include "common/sheets/sheet_density.h"
#include "common/sheets/sheet_source.h"
#include "server/prepare/sheets/page_paint.h"
#include "server/prepare/sheets/painted_sheets.h"

namespace burnish {

EncodedPage PageMaker::make(PageId id, const LevelSheets* finer, LevelSheets& made,
                            const std::function<void()>& ask) const {
  EncodedPage encoded;
  encoded.status = fill(encoded, id, finer, made, ask);
  return encoded;
}

Status PageMaker::fill(EncodedPage& encoded, PageId id, const LevelSheets* finer, LevelSheets& made,
                       const std::function<void()>& ask) const {
  ASSIGN_OR_RETURN(const Page page, scan_.pages.read_page(id));
  auto sheets = finer == nullptr ? paint(encoded, page, ask) : join(page, *finer, ask);
  RETURN_IF_ERROR(sheets.status());
  encoded.texels = sheets->texels();
  encoded.charts = encode_charts(id, sheets->charts);
  for (const Sheet& sheet : sheets->sheets) {
    ask();
    ASSIGN_OR_RETURN(auto bytes, encode_sheet(sheet));
    encoded.sheets.push_back(std::move(bytes));
  }
  return made.keep(std::move(sheets->charts), sheets->sheets);
}

/// Makes sheets of level 0 from the pictures.
Result<PageSheets> PageMaker::paint(EncodedPage& encoded, const Page& page,
                                    const std::function<void()>& ask) const {
  const PagePaint paint(page, scan_.surface, tiles_, finder_, scan_.seams);
  encoded.used_texels = paint.used_texels();
  encoded.lost_triangles = paint.lost_triangles();
  return make_painted_sheets(page, paint, tiles_, {.step = step_, .ask = ask});
}

/// Makes sheets of a coarser level from those of the pages that it replaces.
Result<PageSheets> PageMaker::join(const Page& page, const LevelSheets& finer,
                                   const std::function<void()>& ask) const {
  std::vector<Page> pages;
  std::vector<double> densities;
  for (const PagePatch& patch : page.patches) {
    ASSIGN_OR_RETURN(pages.emplace_back(), scan_.pages.read_page(patch.finer));
    densities.push_back(finer.density(patch.finer));
  }
  std::vector<Sheet> sheets;
  PageSheetsWish wish{.step = step_, .samples_per_side = 2, .ask = ask};
  wish.density = coarse_density(densities, page.triangles.size(), page_area(page, step_));
  wish.source = [&](double density) -> Result<BakeSource> {
    sheets.reserve(pages.size());  // the source keeps pointers
    std::vector<SheetedPage> sheeted;
    for (const Page& replaced : pages) {
      ASSIGN_OR_RETURN(sheets.emplace_back(), finer.read(replaced.id, density));
      sheeted.push_back({&replaced, &finer.charts(replaced.id), &sheets.back()});
    }
    return source_of_sheets(sheeted, step_);
  };
  return make_page_sheets(page, wish);
}

}  // namespace burnish
