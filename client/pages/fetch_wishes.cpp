#include "client/pages/fetch_wishes.h"

namespace burnish {

PagesWish pages_wish(const std::string& scan, std::span<const PageItem> items) {
  PagesWish wish{.scan = scan, .blocks = {}, .pages = {}};
  for (const PageItem item : items)
    (item.kind == PageItem::Kind::kPage ? wish.pages : wish.blocks).push_back(item.number);
  return wish;
}

SheetsWish sheets_wish(const std::string& scan, std::span<const PageItem> items) {
  SheetsWish wish{.scan = scan, .blocks = {}, .charts = {}, .sheets = {}};
  if (!items.empty()) wish.version = items.front().version;
  for (const PageItem item : items) {
    if (item.kind == PageItem::Kind::kSheetBlock) wish.blocks.push_back(item.number);
    if (item.kind == PageItem::Kind::kCharts) wish.charts.push_back(item.number);
    if (item.kind == PageItem::Kind::kSheet) wish.sheets.push_back({item.number, item.halving});
  }
  return wish;
}

}  // namespace burnish
