#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "common/pages/directory.h"

namespace burnish {

/// A block of the directory that has come.
struct KnownBlock {
  DirectoryBlock directory;
  std::vector<uint32_t> coarser_blocks;  ///< that hold the coarser pages of its pages, rising
  uint64_t triangles = 0;                ///< of all its pages
};

/// The directory as far as it has come.
class KnownPages {
 public:
  explicit KnownPages(PageHead head);

  const PageHead& head() const { return head_; }
  uint32_t block_count() const { return static_cast<uint32_t>(blocks_.size()); }
  PageRange pages_of(uint32_t block) const { return ranges_[block]; }
  /// Needs: a page of the scan.
  uint32_t block_of(PageId page) const;
  uint32_t level_zero_blocks() const { return level_zero_blocks_; }

  /// Returns nullptr for a block that is not known.
  const KnownBlock* find_block(uint32_t block) const { return blocks_[block].get(); }
  /// Returns nullptr for a page whose block is not known. Needs: a page of the scan.
  const PageEntry* find(PageId page) const;

  /// Needs: decode_block() made it for this head and index.
  void add(uint32_t index, DirectoryBlock block);
  void forget(uint32_t block);

  uint32_t known_blocks() const { return known_blocks_; }

 private:
  PageHead head_;
  std::vector<PageRange> ranges_;  ///< by block
  uint32_t level_zero_blocks_ = 0;
  std::vector<std::unique_ptr<const KnownBlock>> blocks_;
  uint32_t known_blocks_ = 0;
};

}  // namespace burnish
