#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "common/base/atomic_file.h"
#include "common/base/file_reader.h"
#include "common/base/status.h"
#include "common/pages/directory.h"
#include "common/sheets/chart.h"
#include "common/sheets/sheet.h"
#include "common/sheets/sheet_directory.h"

namespace burnish {

/// The pages and pictures that a sheet file belongs to.
struct SheetOrigin {
  uint64_t pages_fingerprint = 0;  ///< pages_fingerprint() of the page file's head
  uint64_t pictures_fingerprint = 0;

  bool operator==(const SheetOrigin&) const = default;
};

/// Writes a sheet file, which appears whole or not at all. Sheets go to the disk as they come;
/// encoded charts stay in memory until the end, a quarter of a byte a triangle.
class SheetFileWriter {
 public:
  /// Fails: as AtomicFile::create() does.
  static Result<SheetFileWriter> create(const std::filesystem::path& path,
                                        const SheetOrigin& origin);

  /// Appends the next page, from 0 up to the root.
  /// Needs: `charts` is encode_charts() of the page; `sheets` are encode_sheet() of it, the finest
  /// first, 1..kSheetsPerPageMax. Fails: resource_exhausted (the disk).
  Status add(std::span<const uint8_t> charts, std::span<const std::vector<uint8_t>> sheets);

  /// Appends charts and directory, and puts the file in its place. Call once, last.
  /// Needs: all pages of the page file. Fails: resource_exhausted (the disk).
  Status finish(const PageHead& pages);

 private:
  SheetFileWriter(AtomicFile file, const SheetOrigin& origin);
  Status write_blocks(const PageHead& pages);

  AtomicFile file_;
  SheetHead head_;
  std::vector<ChartEntry> charts_;
  Groups<SheetEntry> sheets_;
  std::vector<uint8_t> chart_bytes_;
};

/// An open sheet file. Its directory is in memory, its sheets on the disk. Threads may read at the
/// same time.
class SheetFile {
 public:
  /// Reads the directory and checks all of it. `pages`: of the page file.
  /// Fails: not_found; failed_precondition (sheets of other pages); data_loss that names the
  /// damage; unimplemented (another version).
  static Result<SheetFile> open(const std::filesystem::path& path, const PageHead& pages,
                                uint64_t pages_fingerprint);

  const SheetHead& head() const { return head_; }

  /// Returns the encoded head.
  std::span<const uint8_t> head_bytes() const { return head_bytes_; }
  const ChartEntry& chart_entry(PageId page) const { return charts_[page]; }
  /// Returns the page's sheets, the finest first.
  std::span<const SheetEntry> sheet_entries(PageId page) const { return sheets_[page]; }

  /// Reads an encoded block, charts or a sheet, and checks the checksum. Needs: a block or page of
  /// the scan, and one of the page's sheets. Fails: data_loss that names the damage; as errno says.
  Result<std::vector<uint8_t>> read_block_bytes(uint32_t block) const;
  Result<std::vector<uint8_t>> read_chart_bytes(PageId page) const;
  Result<std::vector<uint8_t>> read_sheet_bytes(PageId page, size_t halving) const;

  /// Decodes a page's charts. Needs: a page of the scan. Fails: data_loss that names the page.
  Result<PageCharts> read_charts(const Page& page) const;

  /// Decodes a sheet and checks it against the directory. Needs: a page of the scan, and one of its
  /// sheets. Fails: data_loss that names the page and the damage.
  Result<Sheet> read_sheet(PageId page, size_t halving) const;

  uint64_t byte_count() const;  ///< in memory

 private:
  explicit SheetFile(FileReader file) : file_(std::move(file)) {}
  Result<uint64_t> find_head() const;
  Status read_head(const PageHead& pages);
  Status read_blocks(const PageHead& pages);

  FileReader file_;
  SheetHead head_;
  std::vector<uint8_t> head_bytes_;
  std::vector<ChartEntry> charts_;
  Groups<SheetEntry> sheets_;
  std::vector<uint64_t> block_offsets_;  ///< blocks + 1
  std::vector<uint64_t> chart_offsets_;  ///< pages + 1
  std::vector<uint64_t> sheet_offsets_;  ///< sheets + 1
};

}  // namespace burnish
