#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "client/scene/page_texture.h"
#include "common/pages/page.h"

namespace burnish {

/// The sheets of a page that are here.
struct StoredSheets {
  std::vector<uint8_t> charts;                 ///< encoded; empty: they are not here
  std::vector<uint8_t> sheet;                  ///< encoded, until it is decoded; empty: none
  uint8_t sheet_halving = 0;                   ///< of `sheet`
  std::shared_ptr<const PageTexture> texture;  ///< null: none
  uint8_t texture_halving = 0;                 ///< of `texture`

  uint64_t bytes() const;
};

/// Keeps charts and sheets by page within a budget of bytes. Makes room at the page that was unused
/// the longest. Takes nothing from a page that the current picture uses.
class SheetStore {
 public:
  explicit SheetStore(uint64_t budget_bytes) : budget_(budget_bytes) {}

  /// Begins the next picture, which uses nothing yet.
  void begin_picture() { ++picture_; }
  /// Keeps the page for this picture. Returns what is here of it; all empty: nothing.
  const StoredSheets& use(PageId page);
  /// Returns nullptr for a page of which nothing is here.
  const StoredSheets* find(PageId page) const;

  // Each puts something in the place of what was there. Returns false, and keeps nothing, if there
  // is no room.
  bool hold_charts(PageId page, std::vector<uint8_t> bytes);
  bool hold_sheet(PageId page, uint8_t halving, std::vector<uint8_t> bytes);
  bool hold_texture(PageId page, uint8_t halving, std::shared_ptr<const PageTexture> texture);

  void drop_charts(PageId page);
  void drop_sheet(PageId page);
  void drop_texture(PageId page);

  uint64_t budget() const { return budget_; }
  uint64_t bytes() const { return bytes_; }
  /// Returns a number that rises when a texture comes or goes.
  uint64_t changes() const { return changes_; }

 private:
  struct Entry {
    StoredSheets stored;
    uint64_t used_in = 0;
  };
  bool make_room(uint64_t bytes);
  template <typename Change>
  bool change(PageId page, uint64_t more, const Change& apply);

  uint64_t budget_;
  uint64_t bytes_ = 0;
  uint64_t picture_ = 0;
  uint64_t changes_ = 0;
  std::map<PageId, Entry> pages_;
};

}  // namespace burnish
