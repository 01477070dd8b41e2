#include "common/page_frames/shown_pages.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "common/base/heap_sort.h"
#include "common/base/limits.h"

namespace burnish {

namespace {

std::string name_of(PageId page) {
  const std::string name = "page " + std::to_string(page_in_file(page));
  if (is_gains(page)) return "gains of " + name;
  return is_colours(page) ? "colours of " + name : name;
}

std::vector<ShownPage> by_number(std::vector<ShownPage> pages) {
  heap_sort(pages, {}, &ShownPage::page);
  return pages;
}

// Returns all numbers that a change names, rising.
std::vector<PageId> named_pages(const PageChange& change) {
  std::vector<PageId> named = change.removed;
  for (const ShownPage& added : change.added) named.push_back(added.page);
  std::ranges::sort(named);
  return named;
}

Status check_names(const PageChange& change, uint32_t page_count) {
  const std::vector<PageId> named = named_pages(change);
  const auto twice = std::ranges::adjacent_find(named);
  if (twice != named.end())
    return invalid_argument(name_of(*twice) + " is named twice in one change");
  for (const PageId page : named)
    if (page_in_file(page) >= page_count)
      return invalid_argument(name_of(page) + " is unknown: the scan has " +
                              std::to_string(page_count) + " pages");
  return Status::ok();
}

}  // namespace

bool ShownPages::shows(PageId page) const {
  return std::ranges::binary_search(pages_, page, {}, &ShownPage::page);
}

Status ShownPages::check(const PageChange& change, uint32_t page_count) const {
  if (change.revision != revision_ + 1)
    return invalid_argument("revision " + std::to_string(change.revision) +
                            " of the shown pages must be " + std::to_string(revision_ + 1));
  const size_t named = change.added.size() + change.removed.size();
  if (named > 2 * kShownPagesMax)
    return resource_exhausted("a change names " + std::to_string(named) + " pages, the limit is " +
                              std::to_string(2 * kShownPagesMax));
  RETURN_IF_ERROR(check_names(change, page_count));
  for (const PageId removed : change.removed)
    if (!shows(removed)) return invalid_argument(name_of(removed) + " is removed but not shown");
  for (const ShownPage& added : change.added)
    if (shows(added.page)) return invalid_argument(name_of(added.page) + " is shown already");
  const size_t shown = pages_.size() + change.added.size() - change.removed.size();
  if (shown > kShownPagesMax)
    return resource_exhausted(std::to_string(shown) + " pages are shown, the limit is " +
                              std::to_string(kShownPagesMax));
  return Status::ok();
}

ShownPages ShownPages::changed(const PageChange& change) const {
  for (const ShownPage& added : change.added)
    BURNISH_CHECK(added.layout != nullptr, name_of(added.page) + " has no layout");
  std::vector<PageId> removed = change.removed;
  std::ranges::sort(removed);
  std::vector<ShownPage> kept;
  std::ranges::copy_if(pages_, std::back_inserter(kept), [&](const ShownPage& shown) {
    return !std::ranges::binary_search(removed, shown.page);
  });
  ShownPages next;
  next.revision_ = revision_ + 1;
  std::ranges::merge(kept, by_number(change.added), std::back_inserter(next.pages_), {},
                     &ShownPage::page, &ShownPage::page);
  return next;
}

ShownPages ShownPages::with_layouts(std::vector<ShownPage> pages) const {
  BURNISH_CHECK(std::ranges::equal(pages, pages_, {}, &ShownPage::page, &ShownPage::page),
                "other pages have the layouts");
  ShownPages other;
  other.revision_ = revision_;
  other.pages_ = std::move(pages);
  return other;
}

}  // namespace burnish
