#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "client/pages/cut_targets.h"
#include "client/pages/page_slots.h"
#include "common/pages/page.h"

namespace burnish {

/// How far a page has come. Each state has what the ones before it have.
enum class PageState : uint8_t {
  kAbsent,
  kHeld,     ///< its encoded bytes are here
  kDecoded,  ///< the page is in memory
  kOnCard,   ///< it has a slot
};

struct CachedPage {
  PageState state = PageState::kHeld;
  std::vector<uint8_t> bytes;
  std::shared_ptr<const Page> page;  ///< from kDecoded on
  PageSlot slot = 0;                 ///< at kOnCard
  uint64_t used_in = 0;              ///< the last picture that used it
  std::list<PageId>::iterator place;
};

/// The pages that are here, within a budget of memory and of slots. Makes room at the page that was
/// unused the longest. Takes decoded pages and their slots first, and bytes when none is left:
/// bytes are small, and decoding is faster than fetching. Takes nothing from a page that the
/// current picture uses.
class PageCache {
 public:
  explicit PageCache(const PageBudget& budget);

  /// Begins the next picture, which uses nothing yet.
  void begin_picture() { ++picture_; }
  /// Keeps the page for this picture. Returns nullptr for an absent page.
  const CachedPage* use(PageId page);

  /// Returns nullptr for an absent page.
  const CachedPage* find(PageId page) const;
  PageState state_of(PageId page) const;

  /// Each returns false and changes nothing if there is no room.
  /// Needs: the page is absent; the page is held; the page is decoded.
  bool hold(PageId page, std::vector<uint8_t> bytes);
  bool decode(PageId page, std::shared_ptr<const Page> decoded);
  bool place(PageId page);

  void drop(PageId page);

  uint64_t resident_bytes() const { return resident_bytes_; }
  const PageSlots& slots() const { return slots_; }
  size_t page_count() const { return pages_.size(); }

 private:
  std::list<PageId>& order_of(PageState state) { return orders_[static_cast<size_t>(state)]; }
  void enter(PageId page, CachedPage& cached, PageState state);
  std::optional<PageId> longest_unused(PageState state);
  bool make_room(uint64_t bytes);
  bool release_one();
  void strip(CachedPage& cached);

  uint64_t budget_bytes_;
  uint64_t resident_bytes_ = 0;
  PageSlots slots_;
  uint64_t picture_ = 0;
  std::unordered_map<PageId, CachedPage> pages_;
  std::list<PageId> orders_[4];  // by state, the longest unused first
};

}  // namespace burnish
