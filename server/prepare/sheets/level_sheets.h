#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "common/base/scratch_file.h"
#include "common/base/status.h"
#include "common/pages/page.h"
#include "common/sheets/chart.h"
#include "common/sheets/sheet.h"

namespace burnish {

/// The sheets of one level, from which those of the next coarser one are baked. Texels lie in a
/// scratch file as they are: packed ones would lose a little at each level. Threads may keep
/// different pages at the same time.
class LevelSheets {
 public:
  /// Fails: as ScratchFile::create().
  static Result<LevelSheets> create(const std::filesystem::path& folder, PageId first,
                                    size_t pages);

  /// Keeps the sheets of one page, the finest first, instead of those before. Fails:
  /// resource_exhausted.
  Status keep(PageCharts charts, std::span<const Sheet> sheets);

  const PageCharts& charts(PageId page) const { return at(page).charts; }

  /// Returns the density of the finest sheet, texels per file unit.
  double density(PageId page) const { return at(page).sheets.front().facts.density; }

  /// Reads the coarsest sheet of at least this density; else the finest. Fails: as
  /// ScratchFile::read().
  Result<Sheet> read(PageId page, double density) const;

  uint64_t texels() const { return bytes_->load() / sizeof(Rgba8); }  ///< of all sheets so far
  uint64_t memory_bytes() const;                                      ///< about

 private:
  struct Kept {
    Sheet facts;  ///< without texels
    uint64_t begin = 0;
  };
  struct KeptPage {
    PageCharts charts;
    std::vector<Kept> sheets;
  };
  LevelSheets(ScratchFile file, PageId first, size_t pages)
      : file_(std::move(file)), first_(first), pages_(pages) {}
  const KeptPage& at(PageId page) const { return pages_[page - first_]; }

  ScratchFile file_;
  PageId first_;
  std::vector<KeptPage> pages_;
  std::unique_ptr<std::atomic<uint64_t>> bytes_ = std::make_unique<std::atomic<uint64_t>>(0);
};

}  // namespace burnish
