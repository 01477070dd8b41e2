#pragma once

#include <vector>

#include "client/pages/cut_chooser.h"
#include "client/pages/known_pages.h"
#include "tests/client/pages/synthetic_scan.h"

namespace burnish {

/// Returns the whole directory of a scan.
inline KnownPages know_all(const SyntheticScan& scan) {
  KnownPages known(scan.directory.head);
  for (uint32_t block = 0; block < known.block_count(); ++block)
    known.add(block, scan.block(block));
  return known;
}

/// The pages of a scan that are ready to be shown: all, less those that a test takes away.
class ReadyPages {
 public:
  explicit ReadyPages(const SyntheticScan& scan) : is_ready_(scan.directory.entries.size(), 1) {
    for (PageId page = 0; page < is_ready_.size(); ++page) pages_.push_back(scan.page(page));
  }

  void set(PageId page, bool ready) { is_ready_[page] = ready ? 1 : 0; }
  FindReady find() const {
    return [this](PageId page) { return is_ready_[page] != 0 ? &pages_[page] : nullptr; };
  }

 private:
  std::vector<Page> pages_;
  std::vector<uint8_t> is_ready_;
};

}  // namespace burnish
