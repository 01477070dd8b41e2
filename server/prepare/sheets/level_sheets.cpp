#include "server/prepare/sheets/level_sheets.h"

#include <utility>

namespace burnish {

Result<LevelSheets> LevelSheets::create(const std::filesystem::path& folder, PageId first,
                                        size_t pages) {
  ASSIGN_OR_RETURN(ScratchFile file, ScratchFile::create(folder));
  return LevelSheets(std::move(file), first, pages);
}

Status LevelSheets::keep(PageCharts charts, std::span<const Sheet> sheets) {
  KeptPage& kept = pages_[sheets.front().page - first_];
  kept.charts = std::move(charts);
  kept.sheets.clear();
  for (const Sheet& sheet : sheets) {
    const std::span<const uint8_t> bytes{reinterpret_cast<const uint8_t*>(sheet.texels.data()),
                                         sheet.texels.size() * sizeof(Rgba8)};
    const uint64_t begin = bytes_->fetch_add(bytes.size());
    RETURN_IF_ERROR(file_.write(begin, bytes));
    kept.sheets.push_back({{sheet.page, sheet.halving, sheet.density, sheet.layout, {}}, begin});
  }
  return Status::ok();
}

uint64_t LevelSheets::memory_bytes() const {
  uint64_t bytes = pages_.size() * sizeof(KeptPage);
  for (const KeptPage& page : pages_) {
    bytes += page.charts.charts.size() * (sizeof(Chart) + page.sheets.size() * sizeof(TexelPlace));
    bytes += page.charts.of_triangle.size() * sizeof(uint16_t);
  }
  return bytes;
}

Result<Sheet> LevelSheets::read(PageId page, double density) const {
  const std::vector<Kept>& sheets = at(page).sheets;
  size_t chosen = 0;
  while (chosen + 1 < sheets.size() && sheets[chosen + 1].facts.density >= density) ++chosen;
  Sheet sheet = sheets[chosen].facts;
  sheet.texels.resize(sheet.layout.texels());
  RETURN_IF_ERROR(file_.read(sheets[chosen].begin, {reinterpret_cast<uint8_t*>(sheet.texels.data()),
                                                    sheet.texels.size() * sizeof(Rgba8)}));
  return sheet;
}

}  // namespace burnish
