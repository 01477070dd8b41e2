// The values that colour a document's surface.

#include <algorithm>
#include <cmath>

#include "client/model/document.h"
#include "client/tools/colours.h"

namespace burnish {

static int8_t to_mark(float signed_part) {
  return static_cast<int8_t>(std::lround(127 * std::clamp(signed_part, -1.0f, 1.0f)));
}

static bool has_values_of(const PageValues& values, size_t vertices) {
  return values.steps.empty() || values.steps.size() == vertices;
}

void Document::set_colour(ColourBy colour) {
  if (std::exchange(colour_, colour) == colour) return;
  surface_->show_colours(colour_ == ColourBy::kScan);
  surface_->marks().clear_values();
  forget_values();
}

// Old values stay until the new ones are here.
void Document::forget_values() {
  ++values_version_;
  fetched_.clear();
}

// Fetches the values of drawn pages that have none, for all of them at once.
void Document::fetch_values() {
  if (colour_ != ColourBy::kBeta && colour_ != ColourBy::kCurvature) return;
  if (is_fetching_values_) return;
  std::vector<PageId> missing;
  for (const PageId page : surface_->drawn_pages())
    if (!fetched_.contains(page)) missing.push_back(page);
  if (missing.empty()) return;
  is_fetching_values_ = true;
  fetched_.insert(missing.begin(), missing.end());  // not again if it fails
  tasks_.start([this, alive = std::weak_ptr(alive_), connection = opened_.connection,
                session = opened_.session.id, pages = std::move(missing), colour = colour_,
                version = values_version_](StopToken) -> Tasks::Completion {
    connection->bring_back();
    const bool is_beta = colour == ColourBy::kBeta;
    auto first =
        connection->page_values(session, is_beta ? CellValue::kBeta : CellValue::kKappa1, pages);
    auto second = is_beta ? first : connection->page_values(session, CellValue::kKappa2, pages);
    return [this, alive, first = std::move(first), second = std::move(second), version] {
      if (alive.expired()) return;
      is_fetching_values_ = false;
      if (version == values_version_) take_values(first, second);
    };
  });
}

// Colours by the principal curvature that is larger in size. For the gradient scale both are it.
void Document::take_values(const Result<std::vector<PageValues>>& first,
                           const Result<std::vector<PageValues>>& second) {
  const Status status = first.is_ok() ? second.status() : first.status();
  if (!status.is_ok()) return log_.failure("colours of the surface", status);
  for (size_t p = 0; p < first->size(); ++p) {
    const PageValues& one = (*first)[p];
    const PageValues& other = (*second)[p];
    const auto vertices = surface_->vertex_count(one.page);
    if (!vertices) fetched_.erase(one.page);  // it has left meanwhile, and may come back
    if (!vertices || !has_values_of(one, *vertices) || !has_values_of(other, *vertices)) continue;
    std::vector<int8_t> marks(*vertices);
    for (size_t v = 0; v < marks.size(); ++v) {
      const float a = one.at(v), b = other.at(v);
      const float value = std::abs(b) > std::abs(a) ? b : a;
      marks[v] =
          to_mark(colour_ == ColourBy::kBeta ? signed_part_of_beta(value)
                                             : signed_part_of_kappa(value, curve_.kappa_range()));
    }
    surface_->marks().set_values(one.page, std::move(marks));
  }
}

}  // namespace burnish
