#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "common/base/atomic_file.h"
#include "common/base/file_reader.h"
#include "common/base/status.h"
#include "common/pages/directory.h"

namespace burnish {

/// Facts of the scan in a page file.
struct PageScan {
  PageGrid grid;
  bool has_colours = false;
  uint64_t vertices = 0;
  uint64_t triangles = 0;
};

/// Writes a page file, which appears whole or not at all. Pages go to the disk as they come; only
/// the directory stays in memory, some 50 bytes a page.
///
///   level 0:  begin_level(), add() for each page in the order of their numbers
///   level 1:  begin_level(), add() ...            and so on up to the root, then finish()
class PageFileWriter {
 public:
  /// Fails: as AtomicFile::create() does.
  static Result<PageFileWriter> create(const std::filesystem::path& path, const PageScan& scan);

  void begin_level();

  /// Returns the number that the next page must have.
  PageId next_page() const { return static_cast<PageId>(directory_.entries.size()); }

  /// Appends a page. The directory's `coarser` lists follow from the patches.
  /// Needs: `page.id` is next_page(); `encoded` is encode_page(page); the patches name pages of the
  /// level before, whose error and edge are not above those of `bounds`.
  /// Fails: resource_exhausted (the disk, or kPagesMax).
  Status add(const Page& page, const PageBounds& bounds, std::span<const uint8_t> encoded);

  /// Appends the directory and puts the file in its place. Call once, last.
  /// Needs: the last level has one page; every other page is in a patch of the next level.
  /// Fails: resource_exhausted (the disk, or kCoarserPerBlockMax).
  Status finish();

 private:
  PageFileWriter(AtomicFile file, const PageScan& scan);
  void gather_coarser();
  Status write_blocks();

  struct Link {
    PageId finer;
    PageId coarser;
  };

  AtomicFile file_;
  PageDirectory directory_;  ///< `coarser` is filled by finish()
  std::vector<Link> links_;
};

/// An open page file. Its head and directory are in memory, its pages on the disk. Threads may read
/// at the same time.
class PageFile {
 public:
  /// Reads the directory and checks all of it. Fails: not_found; data_loss that names the damage;
  /// unimplemented (another version).
  static Result<PageFile> open(const std::filesystem::path& path);

  const PageDirectory& directory() const { return directory_; }

  /// Returns the encoded head.
  std::span<const uint8_t> head_bytes() const { return head_bytes_; }

  /// Reads an encoded block or page, and checks its checksum. Needs: a block or page of the scan.
  /// Fails: data_loss that names the damage; as errno says.
  Result<std::vector<uint8_t>> read_block_bytes(uint32_t block) const;
  Result<std::vector<uint8_t>> read_page_bytes(PageId page) const;

  /// Decodes a page and checks it against the directory. Needs: a page of the scan.
  /// Fails: data_loss that names the page and the damage.
  Result<Page> read_page(PageId page) const;

  uint64_t byte_count() const;  ///< in memory

 private:
  explicit PageFile(FileReader file) : file_(std::move(file)) {}
  Result<uint64_t> find_head() const;
  Status read_head();
  Status read_blocks();
  Result<std::vector<uint8_t>> read_part(std::span<const uint64_t> offsets, uint32_t part) const;
  Result<DirectoryBlock> read_block(uint32_t block) const;

  FileReader file_;
  PageDirectory directory_;
  std::vector<uint8_t> head_bytes_;
  std::vector<uint64_t> page_offsets_;   ///< pages + 1
  std::vector<uint64_t> block_offsets_;  ///< blocks + 1
};

}  // namespace burnish
