#include "client/gl/sheet_shelves.h"

#include <algorithm>

#include "common/base/check.h"

namespace burnish {

static int rounded_up(int size, int step) {
  return (size + step - 1) / step * step;
}

std::optional<ShelfPlace> SheetShelves::take(int width, int height) {
  width = rounded_up(width, kShelfStep);
  height = std::min(rounded_up(height, kShelfHeightStep), side_);
  Shelf* best = nullptr;  // the lowest one that is high enough
  for (Shelf& shelf : shelves_) {
    const bool fits = shelf.height >= height && side_ - shelf.filled >= width;
    const bool is_close = shelf.height <= 2 * height;
    if (fits && is_close && (best == nullptr || shelf.height < best->height)) best = &shelf;
  }
  if (best != nullptr) return put(*best, width);
  for (int layer = 0; layer < layers_; ++layer) {
    if (side_ - tops_[layer] < height) continue;
    shelves_.push_back({layer, tops_[layer], height});
    tops_[layer] += height;
    return put(shelves_.back(), width);
  }
  return std::nullopt;
}

std::optional<ShelfPlace> SheetShelves::put(Shelf& shelf, int width) {
  const ShelfPlace place{shelf.layer, shelf.filled, shelf.y};
  shelf.filled += width;
  ++shelf.count;
  return place;
}

void SheetShelves::give_back(const ShelfPlace& place) {
  const auto shelf = std::ranges::find_if(
      shelves_, [&](const Shelf& each) { return each.layer == place.layer && each.y == place.y; });
  BURNISH_CHECK(shelf != shelves_.end() && shelf->count > 0, "a place is given back once");
  if (--shelf->count == 0) shelf->filled = 0;
}

}  // namespace burnish
