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
#include "server/prepare/sheets/unfinished_sheets.h"

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
                UnfinishedSheets& state)
      : scan_(scan),
        path_(path),
        options_(options),
        need_(need),
        progress_(progress),
        state_(state),
        loop_(progress, "sheets", 0, 1) {}

  Result<bool> build() {
    const uint64_t fingerprint = pages_fingerprint(scan_.pages.head_bytes());
    if (state_.pages_fingerprint != fingerprint) state_ = {.pages_fingerprint = fingerprint};
    state_.report.kept_pages = state_.pages();
    if (!state_.pictures) RETURN_IF_ERROR(decode());
    if (state_.pictures->count == 0) return false;
    RETURN_IF_ERROR(need_.ask_for_pages(std::min<size_t>(kPagesPerBatch, head().page_count())));
    const TriangleFinder finder(scan_.surface.mesh, head().grid, options_.space,
                                {progress_, "sheets", 0, 0});
    const PageMaker maker(scan_, state_.pictures->tiles, finder);
    if (!state_.file) {
      const SheetOrigin origin = {fingerprint, state_.pictures->fingerprint};
      ASSIGN_OR_RETURN(state_.file, SheetFileWriter::create(path_, origin));
    }
    for (; state_.level < head().level_count(); ++state_.level) RETURN_IF_ERROR(make_level(maker));
    RETURN_IF_ERROR(state_.file->finish(head()));
    return true;
  }

 private:
  const PageHead& head() const { return scan_.pages.directory().head; }

  Status decode() {
    const auto start = std::chrono::steady_clock::now();
    const auto admit = [&](uint64_t memory, uint64_t scratch) {
      return need_.ask_for_picture(memory, scratch);
    };
    ASSIGN_OR_RETURN(state_.pictures, decode_pictures(scan_.surface.textures, scan_.name,
                                                      path_.parent_path(), admit, progress_));
    state_.report.pictures = state_.pictures->count;
    state_.report.picture_seconds = seconds_since(start);
    return Status::ok();
  }

  Status make_level(const PageMaker& maker) {
    const auto start = std::chrono::steady_clock::now();
    const PageId begin = head().level_begin(state_.level);
    const uint32_t pages = head().level_pages[state_.level];
    if (!state_.made) {
      ASSIGN_OR_RETURN(state_.made, LevelSheets::create(path_.parent_path(), begin, pages));
      state_.report.levels.push_back({pages});
    }
    while (state_.begin < begin + pages) RETURN_IF_ERROR(make_batch(maker, begin + pages));
    state_.finer = std::exchange(state_.made, std::nullopt);
    state_.report.levels.back().seconds += seconds_since(start);
    return Status::ok();
  }

  Status make_batch(const PageMaker& maker, PageId level_end) {
    const PageId end = std::min<PageId>(state_.begin + kPagesPerBatch, level_end);
    RETURN_IF_ERROR(need_.ask_for_pages(end - state_.begin));
    state_.batch.resize(end - state_.begin);
    const LevelSheets* finer = state_.finer ? &*state_.finer : nullptr;
    parallel_pages(state_.begin, end, head().page_count(), loop_,
                   [&](size_t page, const auto& ask) {
                     auto& encoded = state_.batch[page - state_.begin];
                     if (encoded && encoded->status.is_ok()) return;
                     encoded = maker.make(static_cast<PageId>(page), finer, *state_.made, ask);
                   });
    for (const auto& page : state_.batch) {
      RETURN_IF_ERROR(page->status);
      RETURN_IF_ERROR(state_.file->add(page->charts, page->sheets));
      state_.report.levels.back().texels += page->texels;
      state_.report.used_texels += page->used_texels;
      state_.report.lost_triangles += page->lost_triangles;
    }
    state_.batch.clear();
    state_.begin = end;
    return Status::ok();
  }

  const SheetsInput& scan_;
  const std::filesystem::path& path_;
  const SheetsOptions& options_;
  SheetsNeed& need_;
  const Progress& progress_;
  UnfinishedSheets& state_;
  LoopProgress loop_;
};

/// Builds with all errors as statuses.
Result<bool> build_with(const SheetsInput& scan, const std::filesystem::path& path,
                        const SheetsOptions& options, const Progress& progress,
                        UnfinishedSheets& state) try {
  use_threads(options.threads);
  MachineBudget machine;
  PreparationBudget& budget = options.budget != nullptr ? *options.budget : machine;
  SheetsNeed need(scan.surface.mesh, options, budget);
  return SheetsBuilder(scan, path, options, need, progress, state).build();
} catch (const WorkCancelled&) {
  return cancelled("making sheets was cancelled");
} catch (const ScratchFull& full) {
  return resource_exhausted("making sheets: " + std::string(full.what()));
} catch (const std::bad_alloc&) {
  return resource_exhausted("making sheets: not enough memory");
}

}  // namespace

Result<bool> build_sheets(const SheetsInput& scan, const std::filesystem::path& path,
                          const SheetsOptions& options, const Progress& progress,
                          SheetsReport* report) {
  if (scan.surface.textures.triangles.empty()) return false;
  UnfinishedSheets own;
  UnfinishedSheets& state = options.unfinished != nullptr ? *options.unfinished : own;
  auto built = build_with(scan, path, options, progress, state);
  if (report != nullptr) *report = state.report;
  if (built.status().code() != StatusCode::kCancelled) state = {};
  return built;
}

}  // namespace burnish
