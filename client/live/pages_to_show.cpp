#include "client/live/pages_to_show.h"

#include <algorithm>
#include <iterator>

#include "common/page_frames/page_frame_decoder.h"

namespace burnish {

// Checks look at the numbers of pages alone.
static ShownPage numbered(PageId page) {
  static const auto no_layout = std::make_shared<const PageLayout>();
  return {page, no_layout};
}

Status PagesToShow::change(const std::vector<std::shared_ptr<const Page>>& added,
                           const std::vector<PageId>& removed) {
  PageChange change{.revision = wanted_.revision() + 1, .added = {}, .removed = removed};
  for (const auto& page : added) change.added.push_back(numbered(page->id));
  RETURN_IF_ERROR(wanted_.check(change, page_count_));
  wanted_ = wanted_.changed(change);
  for (const PageId page : removed) pages_.erase(page);
  for (const auto& page : added) pages_.emplace(page->id, page);
  is_changed_ = true;
  return Status::ok();
}

void PagesToShow::restart() {
  said_.clear();
  is_changed_ = true;
  revision_ = shown_revision_ = 0;
}

std::optional<ShowPages> PagesToShow::next() {
  if (!is_changed_ || revision_ - shown_revision_ >= kPageChangesInFlightMax) return std::nullopt;
  is_changed_ = false;
  std::vector<PageId> now;
  for (const ShownPage& page : wanted_.pages()) now.push_back(page.page);
  ShowPages change;
  std::ranges::set_difference(now, said_, std::back_inserter(change.added));
  std::ranges::set_difference(said_, now, std::back_inserter(change.removed));
  if (change.added.empty() && change.removed.empty()) return std::nullopt;
  said_ = std::move(now);
  change.revision = ++revision_;
  return change;
}

std::vector<std::shared_ptr<const Page>> PagesToShow::find(std::span<const PageId> pages) const {
  std::vector<std::shared_ptr<const Page>> found;
  for (const PageId page : pages) found.push_back(pages_.at(page));
  return found;
}

}  // namespace burnish
