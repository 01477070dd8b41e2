#include "client/pages/page_cache.h"

#include <algorithm>
#include <utility>

#include "common/base/check.h"

namespace burnish {

namespace {

// A page in the cache takes this beside its arrays: itself, its place in map and order.
constexpr uint64_t kEntryBytes = sizeof(CachedPage) + sizeof(Page) + 128;

uint64_t byte_count(const Page& page) {
  return page.patches.capacity() * sizeof(PagePatch) +
         page.triangles.capacity() * sizeof(PageTriangle) +
         page.positions.capacity() * sizeof(Vec3i) + page.normals.capacity() * sizeof(Vec3f) +
         page.colours.capacity() * sizeof(Rgba8);
}

}  // namespace

PageCache::PageCache(const PageBudget& budget)
    : budget_bytes_(budget.resident_bytes), slots_(budget.slots()) {}

const CachedPage* PageCache::find(PageId page) const {
  const auto found = pages_.find(page);
  return found == pages_.end() ? nullptr : &found->second;
}

PageState PageCache::state_of(PageId page) const {
  const CachedPage* cached = find(page);
  return cached == nullptr ? PageState::kAbsent : cached->state;
}

const CachedPage* PageCache::use(PageId page) {
  const auto found = pages_.find(page);
  if (found == pages_.end()) return nullptr;
  CachedPage& cached = found->second;
  cached.used_in = picture_;
  std::list<PageId>& order = order_of(cached.state);
  order.splice(order.end(), order, cached.place);
  return &cached;
}

bool PageCache::hold(PageId page, std::vector<uint8_t> bytes) {
  BURNISH_CHECK(!pages_.contains(page), "a page is held once");
  bytes.shrink_to_fit();
  const uint64_t cost = kEntryBytes + bytes.capacity();
  if (!make_room(cost)) return false;
  resident_bytes_ += cost;
  CachedPage& cached = pages_[page];
  cached.bytes = std::move(bytes);
  cached.used_in = picture_;
  cached.place = order_of(PageState::kHeld).insert(order_of(PageState::kHeld).end(), page);
  return true;
}

bool PageCache::decode(PageId page, std::shared_ptr<const Page> decoded) {
  CachedPage& cached = pages_.at(page);
  BURNISH_CHECK(cached.state == PageState::kHeld, "a page is decoded once");
  const uint64_t used_in = std::exchange(cached.used_in, picture_);  // it is not its own room
  const bool has_room = make_room(byte_count(*decoded));
  cached.used_in = used_in;
  if (!has_room) return false;
  resident_bytes_ += byte_count(*decoded);
  cached.page = std::move(decoded);
  enter(page, cached, PageState::kDecoded);
  return true;
}

bool PageCache::place(PageId page) {
  CachedPage& cached = pages_.at(page);
  BURNISH_CHECK(cached.state == PageState::kDecoded, "a page has one slot");
  if (slots_.taken() == slots_.count()) {
    const auto unused = longest_unused(PageState::kOnCard);
    if (!unused) return false;
    slots_.give_back(pages_.at(*unused).slot);
    enter(*unused, pages_.at(*unused), PageState::kDecoded);
  }
  cached.slot = *slots_.take();
  enter(page, cached, PageState::kOnCard);
  return true;
}

void PageCache::drop(PageId page) {
  const auto found = pages_.find(page);
  if (found == pages_.end()) return;
  strip(found->second);
  resident_bytes_ -= kEntryBytes + found->second.bytes.capacity();
  order_of(found->second.state).erase(found->second.place);
  pages_.erase(found);
}

// Leaves the bytes. The state stays, for the caller to change.
void PageCache::strip(CachedPage& cached) {
  if (cached.state == PageState::kOnCard) slots_.give_back(cached.slot);
  if (cached.page != nullptr) resident_bytes_ -= byte_count(*cached.page);
  cached.page.reset();
}

void PageCache::enter(PageId page, CachedPage& cached, PageState state) {
  order_of(cached.state).erase(cached.place);
  cached.state = state;
  cached.place = order_of(state).insert(order_of(state).end(), page);
}

std::optional<PageId> PageCache::longest_unused(PageState state) {
  const auto& order = order_of(state);
  const auto found =
      std::ranges::find_if(order, [&](PageId page) { return pages_.at(page).used_in != picture_; });
  if (found == order.end()) return std::nullopt;
  return *found;
}

bool PageCache::make_room(uint64_t bytes) {
  while (resident_bytes_ + bytes > budget_bytes_)
    if (!release_one()) return false;
  return true;
}

bool PageCache::release_one() {
  for (const PageState state : {PageState::kDecoded, PageState::kOnCard})
    if (const auto page = longest_unused(state)) {
      strip(pages_.at(*page));
      enter(*page, pages_.at(*page), PageState::kHeld);
      return true;
    }
  const auto page = longest_unused(PageState::kHeld);
  if (page) drop(*page);
  return page.has_value();
}

}  // namespace burnish
