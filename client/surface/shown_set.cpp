#include "client/surface/shown_set.h"

#include <algorithm>
#include <unordered_set>

#include "common/base/limits.h"
#include "common/page_frames/shown_pages.h"

namespace burnish {

ShownSet::Change ShownSet::change(const ChosenCut& cut, const PageCache& cache,
                                  const SurfaceFrame* frame, uint64_t vertices_in_flight_max,
                                  uint64_t server_vertices_max) {
  Change change;
  remove(cut, server_vertices_max, change);
  add(cut, cache, frame, vertices_in_flight_max, change);
  for (const PageId extra : extras()) add_extra(extra, cut, cache, change);
  return change;
}

uint64_t ShownSet::vertex_count() const {
  uint64_t vertices = 0;
  for (const auto& [page, count] : shown_) vertices += count;
  return vertices;
}

// `used` lists fine pages first; a coarse page must have its values before a finer one helps.
void ShownSet::add(const ChosenCut& cut, const PageCache& cache, const SurfaceFrame* frame,
                   uint64_t vertices_in_flight_max, Change& change) {
  uint64_t in_flight = 0;
  for (const auto& [page, vertices] : shown_)
    if (frame == nullptr || frame->find(page) == nullptr) in_flight += vertices;
  for (auto wanted = cut.used.rbegin(); wanted != cut.used.rend(); ++wanted) {
    if (shown_.size() >= kShownPagesMax) return;
    const CachedPage* cached = cache.find(wanted->page);
    if (cached == nullptr || cached->page == nullptr || shown_.contains(wanted->page)) continue;
    const auto vertices = static_cast<uint32_t>(cached->page->positions.size());
    const bool fits = vertices_in_flight_max == 0 || in_flight == 0 ||
                      in_flight + vertices <= vertices_in_flight_max;
    if (!fits) return;
    in_flight += vertices;
    shown_[wanted->page] = vertices;
    change.added.push_back(cached->page);
  }
}

std::vector<PageId> ShownSet::extras() const {
  if (!shows_colours_) return {};
  return shows_gains_ ? std::vector{kColourPages, kGainPages} : std::vector{kColourPages};
}

// Pages come before their colours: a picture without a page has a hole.
void ShownSet::add_extra(PageId extra, const ChosenCut& cut, const PageCache& cache,
                         Change& change) {
  for (auto wanted = cut.used.rbegin(); wanted != cut.used.rend(); ++wanted) {
    if (shown_.size() >= kShownPagesMax) return;
    const PageId number = wanted->page | extra;
    const CachedPage* cached = cache.find(wanted->page);
    if (cached == nullptr || cached->page == nullptr || !shown_.contains(wanted->page)) continue;
    if (cached->page->colours.empty() || shown_.contains(number)) continue;
    auto page = std::make_shared<Page>(*cached->page);
    page->id = number;
    shown_[number] = static_cast<uint32_t>(page->positions.size());
    change.added.push_back(std::move(page));
  }
}

// A server that has refused the pages refuses them again as long as they are the same.
void ShownSet::remove(const ChosenCut& cut, uint64_t server_vertices_max, Change& change) {
  std::unordered_set<PageId> needed(cut.pages.begin(), cut.pages.end());
  for (const WantedPage& wanted : cut.used) needed.insert(wanted.page);
  const std::vector<PageId> pages(needed.begin(), needed.end()), more = extras();
  for (const PageId page : pages)
    for (const PageId extra : more) needed.insert(page | extra);
  std::vector<PageId> unneeded;
  for (const auto& [page, vertices] : shown_)
    if (!needed.contains(page)) unneeded.push_back(page);
  const size_t kept_max = std::max<size_t>(16, shown_.size() / 5);
  const bool is_refused = server_vertices_max > 0 && vertex_count() > server_vertices_max;
  const bool is_room_short = is_refused || needed.size() + unneeded.size() > kShownPagesMax;
  if (unneeded.size() <= kept_max && !is_room_short) return;
  for (const PageId page : unneeded) shown_.erase(page);
  change.removed = std::move(unneeded);
}

}  // namespace burnish
