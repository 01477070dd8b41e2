// Shows the protected region, and where the palette's curves rule, over a document's surface.

#include <algorithm>
#include <cmath>

#include "client/model/document.h"

namespace burnish {

void Document::show_over(bool protection, bool curves) {
  over_wish_ = {protection, curves};
}

// Older servers tell a protection as cell fields.
Document::Over Document::over_now() const {
  const auto is_protecting = [](const HistoryEntry& entry) {
    return (entry.kind == EditKind::kProtect || entry.kind == EditKind::kCellFields) &&
           entry.enabled;
  };
  const bool is_wanted = over_wish_.protection || brush_.is_drawing();
  return {is_wanted && std::ranges::any_of(history_, is_protecting),
          over_wish_.curves && !palette().curves.empty()};
}

// The old stays until the new is here.
void Document::forget_over() {
  ++over_version_;
  fetched_over_.clear();
}

// Fetches what the drawn pages lack, for all of them at once.
void Document::fetch_over() {
  const Over over = over_now();
  if (over_ != over) {
    over_ = over;
    forget_over();
    if (over == Over()) surface_->marks().clear_overlays();
  }
  if (over == Over() || is_fetching_over_) return;
  std::vector<PageId> missing;
  for (const PageId page : surface_->drawn_pages())
    if (!fetched_over_.contains(page)) missing.push_back(page);
  if (missing.empty()) return;
  is_fetching_over_ = true;
  fetched_over_.insert(missing.begin(), missing.end());  // not again if it fails
  tasks_.start([this, alive = std::weak_ptr(alive_), connection = opened_.connection,
                session = opened_.session.id, pages = std::move(missing), over,
                version = over_version_](StopToken) -> Tasks::Completion {
    connection->bring_back();
    const auto ask = [&](bool is_asked, CellValue value) -> Result<std::vector<PageValues>> {
      if (!is_asked) return std::vector<PageValues>();
      return connection->page_values(session, value, pages);
    };
    auto held = ask(over.protection, CellValue::kProtected);
    auto ruled = ask(over.curves, CellValue::kCurve);
    return [this, alive, over, held = std::move(held), ruled = std::move(ruled), version] {
      if (alive.expired()) return;
      is_fetching_over_ = false;
      if (version == over_version_) take_over(over, held, ruled);
    };
  });
}

static bool is_one_per_vertex(const PageValues& values, size_t vertices) {
  return values.steps.empty() || values.steps.size() == vertices;
}

void Document::take_over(const Over& over, const Result<std::vector<PageValues>>& held,
                         const Result<std::vector<PageValues>>& ruled) {
  const Status status = held.is_ok() ? ruled.status() : held.status();
  if (!status.is_ok()) return log_.failure("colours over the surface", status);
  const size_t pages = std::max(held->size(), ruled->size());
  for (size_t p = 0; p < pages; ++p) {
    const PageId page = over.protection ? (*held)[p].page : (*ruled)[p].page;
    const auto vertices = surface_->vertex_count(page);
    if (!vertices) fetched_over_.erase(page);  // it has left meanwhile, and may come back
    if (!vertices || (over.protection && !is_one_per_vertex((*held)[p], *vertices)) ||
        (over.curves && !is_one_per_vertex((*ruled)[p], *vertices)))
      continue;
    std::vector<uint16_t> overlays(*vertices);
    for (size_t v = 0; v < overlays.size(); ++v) {
      const long curve = over.curves ? std::lround((*ruled)[p].at(v)) : 0;
      std::optional<uint32_t> colour;
      if (curve > 0 && static_cast<size_t>(curve) <= palette().curves.size())
        colour = palette().curves[static_cast<size_t>(curve) - 1].colour;
      overlays[v] = packed_overlay(colour, over.protection && (*held)[p].at(v) > 0.5f);
    }
    surface_->marks().set_overlays(page, std::move(overlays));
  }
}

}  // namespace burnish
