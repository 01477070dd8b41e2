#include "client/surface/page_marks.h"

#include <cmath>
#include <utility>

#include "common/base/check.h"

namespace burnish {

void PageMarks::set_values(PageId page, std::vector<int8_t> values) {
  values_[page] = std::make_shared<const std::vector<int8_t>>(std::move(values));
}

void PageMarks::set_overlays(PageId page, std::vector<uint16_t> overlays) {
  overlays_[page] = std::make_shared<const std::vector<uint16_t>>(std::move(overlays));
}

template <typename ByPage>
static auto found_in(const ByPage& map, PageId page) -> typename ByPage::mapped_type {
  const auto found = map.find(page);
  return found == map.end() ? nullptr : found->second;
}

static uint8_t tint_byte(float weight) {
  return static_cast<uint8_t>(std::lround(255 * weight));
}

bool PageMarks::update(PageId page, std::span<const Vec3i> cells, Mark& mark) const {
  const auto values = found_in(values_, page);
  const auto overlays = found_in(overlays_, page);
  const bool are_values_new = mark.values != values || mark.overlays != overlays;
  const bool is_tint_new = tint_.update(cells, mark.tint, mark.weights);
  if (!are_values_new && !is_tint_new) return false;
  BURNISH_CHECK(values == nullptr || values->size() == cells.size(), "one value per vertex");
  BURNISH_CHECK(overlays == nullptr || overlays->size() == cells.size(), "one overlay per vertex");
  mark.values = values;
  mark.overlays = overlays;
  mark.marks.assign(cells.size(), {});
  for (size_t v = 0; v < cells.size(); ++v) {
    if (values) mark.marks[v].value = (*values)[v];
    if (overlays) mark.marks[v].overlay = (*overlays)[v];
    if (!mark.weights.empty()) mark.marks[v].tint = tint_byte(mark.weights[v]);
  }
  return true;
}

}  // namespace burnish
