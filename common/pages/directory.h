#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/groups.h"
#include "common/base/status.h"
#include "common/base/types.h"
#include "common/pages/page.h"
#include "common/pages/page_grid.h"

namespace burnish {

/// A sphere and two lengths that bound what a picture needs to know of a page, or of all pages of a
/// block. File units; the centre is relative to PageGrid::origin.
struct PageBounds {
  Vec3f centre = Vec3f::Zero();
  float radius = 0;  ///< the sphere holds all vertices
  float error = 0;   ///< how far the coarser triangles that replace the page are from the scan
  float edge = 0;    ///< mean edge of those triangles

  bool operator==(const PageBounds&) const = default;
};

/// Facts of a page for a picture that does not have it yet. Error and edge of a coarser page are
/// never below those of the pages that it replaces. Nothing replaces the root, so its two are a
/// choice: the size of the scan does.
struct PageEntry {
  PageBounds bounds;
  uint32_t bytes = 0;  ///< of the encoded page
  uint16_t vertices = 0;
  uint16_t triangles = 0;

  bool operator==(const PageEntry&) const = default;
};

/// Up to kPagesPerBlock consecutive pages of one level, as the head lists them.
struct PageBlock {
  PageBounds bounds;        ///< the sphere around all, the largest error and edge
  uint64_t page_begin = 0;  ///< where the first of its pages lies in the file, bytes
  uint32_t bytes = 0;       ///< of the encoded block

  bool operator==(const PageBlock&) const = default;
};

struct PageRange {
  PageId begin = 0;
  PageId end = 0;

  uint32_t count() const { return end - begin; }
};

/// The part of the page file that a client reads first.
struct PageHead {
  PageGrid grid;
  bool has_colours = false;
  uint64_t scan_vertices = 0;
  uint64_t scan_triangles = 0;
  std::vector<uint32_t> level_pages;  ///< pages of each level, the finest first; the last has one
  std::vector<PageBlock> blocks;      ///< in the order of pages
  uint64_t page_bytes = 0;            ///< of all pages; the blocks follow them in the file
  uint64_t block_bytes = 0;           ///< of all blocks

  int level_count() const { return static_cast<int>(level_pages.size()); }
  uint32_t page_count() const;
  PageId root() const { return page_count() - 1; }
  /// Needs: a level, or level_count() for the end.
  PageId level_begin(int level) const;
  /// Needs: a page of the scan.
  int level_of(PageId page) const;
  /// Follows from `level_pages`: blocks do not cross levels.
  uint32_t block_count() const;
  /// Needs: a page of the scan.
  uint32_t block_of(PageId page) const;
  /// Needs: a block.
  PageRange pages_of(uint32_t block) const;
  /// Returns the end of a block's pages in the file, bytes. Needs: a block.
  uint64_t page_end(uint32_t block) const;
};

/// The entries of one block. Blocks are decoded by themselves.
struct DirectoryBlock {
  PageId begin = 0;  ///< the first of its pages
  std::vector<PageEntry> entries;
  Groups<PageId> coarser;  ///< per entry, as in PageDirectory
};

/// All that is known of a scan's pages without the pages.
struct PageDirectory {
  PageHead head;
  std::vector<PageEntry> entries;  ///< by page
  /// Per page the pages of the next coarser level that have a patch for it, rising. Empty for the
  /// root alone.
  Groups<PageId> coarser;
};

/// Returns the bounds of several pages together. Needs: at least one.
PageBounds join_bounds(std::span<const PageEntry> entries);

/// Checks that a decoded page can stand at its place: it is the page that was asked for, its
/// positions are on the grid, its patches replace pages of the next finer level, and it has colours
/// when the scan has. Fails: data_loss that names the page, the thing, its value and its limit.
Status check_page_in_scan(const Page& page, PageId id, const PageHead& head);

/// Checks the same, that the page is as large as its entry says, and that its patches are those of
/// the `coarser` lists. Fails: as check_page_in_scan() does.
Status check_page_in_directory(const Page& page, PageId id, const PageDirectory& directory);

}  // namespace burnish
