#include <algorithm>
#include <numeric>
#include <utility>

#include "client/publish/page_parts.h"
#include "common/pages/directory_codec.h"
#include "common/sheets/sheet_directory.h"

namespace burnish {

namespace {

constexpr const char* kSheetsPhase = "publishing textures";
constexpr uint32_t kPagesPerFetch = 4;  // with their charts and sheets within all limits of a fetch

/// The server's answer to a wish.
struct FetchedSheets {
  std::vector<PagePart> blocks, charts;
  std::vector<SheetPart> sheets;
};

Result<FetchedSheets> fetch(Connection& connection, const SheetsWish& wish) {
  FetchedSheets fetched;
  const auto into = [](auto& list) {
    return [&list](auto part) {
      list.push_back(std::move(part));
      return true;
    };
  };
  RETURN_IF_ERROR(connection.fetch_sheets(
      wish, {into(fetched.blocks), into(fetched.charts), into(fetched.sheets)}));
  const bool is_whole = fetched.blocks.size() == wish.blocks.size() &&
                        fetched.charts.size() == wish.charts.size() &&
                        fetched.sheets.size() == wish.sheets.size();
  if (is_whole) return fetched;
  return data_loss("server " + connection.server() + " sent other sheets than were asked for");
}

/// Returns how many sheets each page of a block has.
Result<std::vector<uint32_t>> sheet_counts(const PagePart& part, const SheetHead& head,
                                           const PageHead& pages) {
  ASSIGN_OR_RETURN(const SheetBlock block,
                   decode_sheet_block(part.bytes, head, pages, part.number));
  std::vector<uint32_t> counts;
  for (size_t page = 0; page < block.charts.size(); ++page)
    counts.push_back(static_cast<uint32_t>(block.sheets[page].size()));
  return counts;
}

/// Writes the blocks, and returns how many sheets each page of the scan has.
Result<std::vector<uint32_t>> write_blocks(Connection& connection, const Opening& opening,
                                           const PageHead& pages, PartsWriter& parts) {
  ASSIGN_OR_RETURN(const SheetHead head, decode_sheet_head(opening.sheets.head, pages));
  std::vector<uint32_t> counts;
  for (uint32_t number = 0; number < pages.block_count(); ++number) {
    ASSIGN_OR_RETURN(
        const FetchedSheets fetched,
        fetch(connection, {opening.scan.scan.id, {number}, {}, {}, opening.sheets.version}));
    RETURN_IF_ERROR(parts.add(sheet_block_event(fetched.blocks.front())));
    ASSIGN_OR_RETURN(const auto of_block, sheet_counts(fetched.blocks.front(), head, pages));
    counts.insert(counts.end(), of_block.begin(), of_block.end());
  }
  return counts;
}

SheetsWish wish_for(const Opening& opening, uint32_t begin, uint32_t end,
                    const std::vector<uint32_t>& counts) {
  SheetsWish wish{opening.scan.scan.id, {}, {}, {}, opening.sheets.version};
  for (uint32_t page = begin; page < end; ++page) {
    wish.charts.push_back(page);
    for (uint32_t halving = 0; halving < counts[page]; ++halving)
      wish.sheets.push_back({page, halving});
  }
  return wish;
}

Status add_page(const PagePart& charts, const FetchedSheets& fetched, SheetsPerPage slots,
                PartsWriter& parts) {
  RETURN_IF_ERROR(parts.add(charts_event(charts)));
  for (uint32_t halving = 0; halving < slots; ++halving) {
    const SheetNumber number{charts.number, halving};
    const auto sheet = std::ranges::find(fetched.sheets, number, &SheetPart::number);
    const bool is_there = sheet != fetched.sheets.end();
    RETURN_IF_ERROR(parts.add(is_there ? sheet_event(*sheet) : std::string()));
  }
  return Status::ok();
}

}  // namespace

Result<SheetsPerPage> write_sheet_parts(Connection& connection, const Opening& opening,
                                        PartsWriter& parts, const Progress& progress) {
  if (!opening.sheets.has_sheets()) return 0;
  ASSIGN_OR_RETURN(const PageHead pages, decode_head(opening.pages.head));
  ASSIGN_OR_RETURN(const auto counts, write_blocks(connection, opening, pages, parts));
  const SheetsPerPage slots = *std::ranges::max_element(counts);
  for (uint32_t begin = 0; begin < pages.page_count(); begin += kPagesPerFetch) {
    if (!report(progress, kSheetsPhase, static_cast<double>(begin) / pages.page_count()))
      return cancelled("cancelled");
    const uint32_t end = std::min(begin + kPagesPerFetch, pages.page_count());
    ASSIGN_OR_RETURN(const FetchedSheets fetched,
                     fetch(connection, wish_for(opening, begin, end, counts)));
    for (const PagePart& charts : fetched.charts)
      RETURN_IF_ERROR(add_page(charts, fetched, slots, parts));
  }
  return slots;
}

}  // namespace burnish
