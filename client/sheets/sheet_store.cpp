#include "client/sheets/sheet_store.h"

#include <algorithm>
#include <utility>

namespace burnish {

uint64_t StoredSheets::bytes() const {
  return charts.size() + sheet.size() + (texture ? texture->bytes() : 0);
}

const StoredSheets& SheetStore::use(PageId page) {
  Entry& entry = pages_[page];
  entry.used_in = picture_;
  return entry.stored;
}

const StoredSheets* SheetStore::find(PageId page) const {
  const auto found = pages_.find(page);
  return found == pages_.end() ? nullptr : &found->second.stored;
}

bool SheetStore::make_room(uint64_t bytes) {
  while (bytes_ + bytes > budget_) {
    const auto oldest =
        std::ranges::min_element(pages_, {}, [](const auto& page) { return page.second.used_in; });
    if (oldest == pages_.end() || oldest->second.used_in == picture_) return false;
    bytes_ -= oldest->second.stored.bytes();
    changes_ += oldest->second.stored.texture != nullptr;
    pages_.erase(oldest);
  }
  return true;
}

template <typename Change>
bool SheetStore::change(PageId page, uint64_t more, const Change& apply) {
  const auto found = pages_.find(page);
  if (found == pages_.end()) return false;  // no picture has used it
  const uint64_t used_in = std::exchange(found->second.used_in, picture_);
  const bool has_room = make_room(more);  // takes nothing of this page
  found->second.used_in = used_in;
  if (!has_room) return false;
  StoredSheets& stored = found->second.stored;
  bytes_ -= stored.bytes();
  apply(stored);
  bytes_ += stored.bytes();
  return true;
}

bool SheetStore::hold_charts(PageId page, std::vector<uint8_t> bytes) {
  const uint64_t more = bytes.size();
  return change(page, more, [&](StoredSheets& stored) { stored.charts = std::move(bytes); });
}

bool SheetStore::hold_sheet(PageId page, uint8_t halving, std::vector<uint8_t> bytes) {
  const uint64_t more = bytes.size();
  return change(page, more, [&](StoredSheets& stored) {
    stored.sheet = std::move(bytes);
    stored.sheet_halving = halving;
  });
}

bool SheetStore::hold_texture(PageId page, uint8_t halving,
                              std::shared_ptr<const PageTexture> texture) {
  const uint64_t more = texture->bytes();
  return change(page, more, [&](StoredSheets& stored) {
    stored.texture = std::move(texture);
    stored.texture_halving = halving;
    stored.sheet = {};
    ++changes_;
  });
}

void SheetStore::drop_charts(PageId page) {
  change(page, 0, [](StoredSheets& stored) { stored.charts = {}; });
}

void SheetStore::drop_texture(PageId page) {
  change(page, 0, [this](StoredSheets& stored) {
    changes_ += stored.texture != nullptr;
    stored.texture = nullptr;
  });
}

void SheetStore::drop_sheet(PageId page) {
  change(page, 0, [](StoredSheets& stored) { stored.sheet = {}; });
}

}  // namespace burnish
