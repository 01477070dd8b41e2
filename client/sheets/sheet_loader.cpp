#include "client/sheets/sheet_loader.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "client/sheets/sheet_choice.h"
#include "common/sheets/sheet_limits.h"

namespace burnish {

static constexpr double kBudgetAim = 0.8;  // the rest is for encoded sheets, and sheets beside

void SheetLoader::look(const SheetQuestion& question, const KnownPages& pages, Time now) {
  is_fine_ = question.is_at_rest && (is_fine_ || is_complete_);
  missing_.clear();
  wanted_.clear();
  held_.clear();
  is_coarse_ = false;
  store_.begin_picture();
  list_wants(question, pages);
  const float coarser = coarseness();
  is_coarse_ |= coarser > 1;
  for (const Want& want : wants_) take_stock_of(want, coarser);
  is_complete_ = wanted_.empty() && held_.empty();
  if (!question.may_ask) missing_.clear();
  requests_.make_plan(missing_, question.link, now,
                      [this](PageItem item) { return wanted_.contains(item); });
}

void SheetLoader::list_wants(const SheetQuestion& question, const KnownPages& pages) {
  wants_.clear();
  const float texels = is_fine_ ? kTexelsPerPixelStill : kTexelsPerPixelMoving;
  for (const PageId page : question.drawn) {
    const PageEntry* entry = pages.find(page);
    if (entry == nullptr) continue;
    const uint32_t block = pages.block_of(page);
    const float needed =
        needed_density(question.view, entry->bounds, question.largest_move, texels);
    const float density = 1 / std::max(entry->bounds.edge, 1e-30f);
    if (const auto facts = sheets_.find(block, page))
      wants_.push_back({page, block, *facts, needed, density});
    else
      miss(PageItem::of_sheet_block(block, version_), sheets_.head().blocks[block].bytes,
           needed / density);
  }
}

// All sheets of a picture become coarser alike if they do not fit into memory.
float SheetLoader::coarseness() const {
  float coarser = 1;
  for (size_t halvings = 0; halvings < kSheetsPerPageMax; ++halvings, coarser *= 2) {
    uint64_t bytes = 0;
    for (const Want& want : wants_)
      bytes += texture_bytes(want.facts.sheets[coarsest_enough(want.facts, want.needed / coarser)]);
    if (static_cast<double>(bytes) <= kBudgetAim * static_cast<double>(store_.budget())) break;
  }
  return coarser;
}

void SheetLoader::take_stock_of(const Want& want, float coarser) {
  const StoredSheets& stored = store_.use(want.page);
  const uint8_t halving = coarsest_enough(want.facts, want.needed / coarser);
  const bool is_too_fine = coarser > 1 && stored.texture && stored.texture_halving < halving;
  if (is_too_fine) store_.drop_texture(want.page);
  if (stored.texture && stored.texture_halving <= halving) return;
  const float here = stored.texture ? std::ldexp(want.facts.charts.density, -stored.texture_halving)
                                    : want.density;
  const PageItem charts = PageItem::of_charts(want.page, version_);
  const PageItem sheet = PageItem::of_sheet(want.page, halving, version_);
  const PageFailures& failures = requests_.failures();
  if (failures.is_given_up(charts) || failures.is_given_up(sheet)) return void(is_coarse_ = true);
  const SheetEntry& entry = want.facts.sheets[halving];
  const bool has_sheet = !stored.sheet.empty() && stored.sheet_halving == halving;
  if (stored.charts.empty()) miss(charts, want.facts.charts.bytes, want.needed / here);
  if (!has_sheet && !decoding_.contains(sheet)) miss(sheet, entry.bytes, want.needed / here);
  if (!stored.charts.empty() && (has_sheet || decoding_.contains(sheet)))
    held_.push_back(
        {sheet, {entry.width, entry.height}, std::ldexp(want.facts.charts.density, -halving)});
}

void SheetLoader::miss(PageItem item, uint32_t bytes, float excess) {
  if (requests_.failures().is_given_up(item)) return void(is_coarse_ = true);
  if (!wanted_.insert(item).second) return;
  missing_.push_back({item, bytes, excess});
}

void SheetLoader::on_arrival(PageItem item, Result<std::vector<uint8_t>> bytes, Time now) {
  requests_.on_arrival(item);
  if (!bytes.is_ok()) return requests_.on_failure(item, bytes.status(), now);
  hold(item, std::move(*bytes), now);
}

// Success of charts and sheets is known when they are decoded.
void SheetLoader::hold(PageItem item, std::vector<uint8_t> bytes, Time now) {
  if (item.kind == PageItem::Kind::kSheetBlock) {
    const Status added = sheets_.add(item.number, bytes);
    if (!added.is_ok()) return requests_.on_failure(item, added, now);
    return requests_.failures().on_success(item);
  }
  if (store_.find(item.number) == nullptr) return;  // no picture has drawn the page of late
  const bool has_room = item.kind == PageItem::Kind::kCharts
                            ? store_.hold_charts(item.number, std::move(bytes))
                            : store_.hold_sheet(item.number, item.halving, std::move(bytes));
  if (!has_room)
    requests_.on_failure(item,
                         resource_exhausted("no room for sheets within a budget of " +
                                            std::to_string(store_.budget()) + " bytes"),
                         now);
}

void SheetLoader::on_decoded(DecodedTexture decoded, Time now) {
  decoding_.erase(decoded.sheet);
  const PageId page = decoded.sheet.number;
  if (decoded.texture == nullptr) {
    if (decoded.damaged.kind == PageItem::Kind::kCharts)
      store_.drop_charts(page);
    else
      store_.drop_sheet(page);
    return requests_.on_failure(decoded.damaged, decoded.status, now);
  }
  requests_.failures().on_success(PageItem::of_charts(page, version_));
  requests_.failures().on_success(decoded.sheet);
  const StoredSheets* stored = store_.find(page);
  const bool is_finer = stored != nullptr && (stored->texture == nullptr ||
                                              stored->texture_halving > decoded.sheet.halving);
  if (is_finer) store_.hold_texture(page, decoded.sheet.halving, std::move(decoded.texture));
}

std::shared_ptr<const PageTexture> SheetLoader::texture(PageId page) const {
  const StoredSheets* stored = store_.find(page);
  return stored == nullptr ? nullptr : stored->texture;
}

}  // namespace burnish
