#include "server/prepare/sheets/build_sheets.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <optional>
#include <utility>

#include "common/base/heard_loop.h"
#include "common/base/parallel.h"
#include "common/pages/directory_codec.h"
#include "common/sheets/sheet_file.h"
#include "server/prepare/sheets/decode_pictures.h"
#include "server/prepare/sheets/level_sheets.h"
#include "server/prepare/sheets/page_maker.h"
#include "server/prepare/sheets/parallel_pages.h"
#include "server/prepare/sheets/sheets_need.h"
#include "server/prepare/sheets/triangle_finder.h"

namespace burnish {

namespace {

constexpr size_t kPagesPerBatch = 64;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

class SheetsBuilder {
 public:
  SheetsBuilder(const SheetsInput& scan, const std::filesystem::path& path,
                const SheetsOptions& options, SheetsNeed& need, const Progress& progress,
                SheetsReport& report)
      : scan_(scan),
        path_(path),
        options_(options),
        need_(need),
        progress_(progress),
        report_(report),
        loop_(progress, "sheets", 0, 1) {}

  Result<bool> build() {
    const auto start = std::chrono::steady_clock::now();
    const auto admit = [&](uint64_t memory, uint64_t scratch) {
      return need_.ask_for_picture(memory, scratch);
    };
    ASSIGN_OR_RETURN(
        const DecodedPictures pictures,
        decode_pictures(scan_.surface.textures, scan_.name, path_.parent_path(), admit, progress_));
    report_.pictures = pictures.count;
    report_.picture_seconds = seconds_since(start);
    if (pictures.count == 0) return false;
    RETURN_IF_ERROR(need_.ask_for_pages(std::min<size_t>(kPagesPerBatch, head().page_count())));
    const TriangleFinder finder(scan_.surface.mesh, head().grid, options_.space,
                                {progress_, "sheets", 0, 0});
    const PageMaker maker(scan_, pictures.tiles, finder);
    const SheetOrigin origin = {pages_fingerprint(scan_.pages.head_bytes()), pictures.fingerprint};
    ASSIGN_OR_RETURN(SheetFileWriter file, SheetFileWriter::create(path_, origin));
    RETURN_IF_ERROR(make_levels(maker, file));
    RETURN_IF_ERROR(file.finish(head()));
    return true;
  }

 private:
  const PageHead& head() const { return scan_.pages.directory().head; }

  Status make_levels(const PageMaker& maker, SheetFileWriter& file) {
    std::optional<LevelSheets> finer;
    for (int level = 0; level < head().level_count(); ++level) {
      const auto start = std::chrono::steady_clock::now();
      ASSIGN_OR_RETURN(LevelSheets made,
                       LevelSheets::create(path_.parent_path(), head().level_begin(level),
                                           head().level_pages[level]));
      report_.levels.push_back({head().level_pages[level]});
      for (PageId begin = head().level_begin(level); begin < head().level_begin(level + 1);
           begin += kPagesPerBatch)
        RETURN_IF_ERROR(make_batch(maker, finer ? &*finer : nullptr, made, begin,
                                   head().level_begin(level + 1), file));
      finer = std::move(made);
      report_.levels.back().seconds = seconds_since(start);
    }
    return Status::ok();
  }

  Status make_batch(const PageMaker& maker, const LevelSheets* finer, LevelSheets& made,
                    PageId begin, PageId level_end, SheetFileWriter& file) {
    const PageId end = std::min<PageId>(begin + kPagesPerBatch, level_end);
    RETURN_IF_ERROR(need_.ask_for_pages(end - begin));
    std::vector<EncodedPage> batch(end - begin);
    parallel_pages(begin, end, head().page_count(), loop_, [&](size_t page, const auto& ask) {
      batch[page - begin] = maker.make(static_cast<PageId>(page), finer, made, ask);
    });
    for (const EncodedPage& page : batch) {
      RETURN_IF_ERROR(page.status);
      RETURN_IF_ERROR(file.add(page.charts, page.sheets));
      report_.levels.back().texels += page.texels;
      report_.used_texels += page.used_texels;
      report_.lost_triangles += page.lost_triangles;
    }
    return Status::ok();
  }

  const SheetsInput& scan_;
  const std::filesystem::path& path_;
  const SheetsOptions& options_;
  SheetsNeed& need_;
  const Progress& progress_;
  SheetsReport& report_;
  LoopProgress loop_;
};

}  // namespace

Result<bool> build_sheets(const SheetsInput& scan, const std::filesystem::path& path,
                          const SheetsOptions& options, const Progress& progress,
                          SheetsReport* report) try {
  SheetsReport own_report;
  SheetsReport& filled = report != nullptr ? *report : own_report;
  filled = {};
  if (scan.surface.textures.triangles.empty()) return false;
  use_threads(options.threads);
  MachineBudget machine;
  PreparationBudget& budget = options.budget != nullptr ? *options.budget : machine;
  SheetsNeed need(scan.surface.mesh, options, budget);
  return SheetsBuilder(scan, path, options, need, progress, filled).build();
} catch (const WorkCancelled&) {
  return cancelled("making sheets was cancelled");
} catch (const ScratchFull& full) {
  return resource_exhausted("making sheets: " + std::string(full.what()));
} catch (const std::bad_alloc&) {
  return resource_exhausted("making sheets: not enough memory");
}

}  // namespace burnish
