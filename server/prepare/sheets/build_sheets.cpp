#include "server/prepare/sheets/build_sheets.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <new>
#include <optional>
#include <utility>

#include "common/base/heard_loop.h"
#include "common/base/parallel.h"
#include "common/pages/directory_codec.h"
#include "common/sheets/chart_codec.h"
#include "common/sheets/sheet_codec.h"
#include "common/sheets/sheet_density.h"
#include "common/sheets/sheet_file.h"
#include "common/sheets/sheet_limits.h"
#include "common/sheets/sheet_source.h"
#include "server/prepare/sheets/decode_pictures.h"
#include "server/prepare/sheets/level_sheets.h"
#include "server/prepare/sheets/page_paint.h"
#include "server/prepare/sheets/page_sheets.h"
#include "server/prepare/sheets/parallel_pages.h"
#include "server/prepare/sheets/picture_sampler.h"
#include "server/prepare/sheets/triangle_finder.h"

namespace burnish {

namespace {

constexpr size_t kPagesPerBatch = 64;
constexpr uint64_t kSheetTexelsMax = uint64_t{kSheetSideMax} * kSheetSideMax;
constexpr double kAllHalvings = 4.0 / 3;

// Of memory.
constexpr uint64_t kBytesPerThread = 64 << 20;  // a page's sheets, its finer pages', tiles
constexpr uint64_t kBytesPerTriangle = 40;      // of the finder; charts of two levels
constexpr uint64_t kBytesPerVertex = 48;        // of the finder

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Promises memory and disk to the budget before they are taken.
class SheetsNeed {
 public:
  SheetsNeed(const SheetsInput& scan, const SheetsOptions& options, PreparationBudget& budget)
      : space_(options.space), budget_(budget) {
    const MeshView mesh = scan.surface.mesh;
    const uint64_t arrays =
        mesh.triangles.size() * kBytesPerTriangle + mesh.vertices.size() * kBytesPerVertex;
    arrays_in_memory_ = std::min(arrays, options.space.memory_bytes_max());
    arrays_in_files_ = arrays - arrays_in_memory_;
    held_bytes_ = options.held_bytes;
    need_.counts.triangles = mesh.triangles.size();
    need_.counts.vertices = mesh.vertices.size();
  }

  /// A picture comes, before any array is there.
  Status ask_for_picture(uint64_t memory_bytes, uint64_t scratch_bytes) {
    return ask(memory_bytes, scratch_bytes, 0);
  }

  /// So many pages are made by all threads.
  Status ask_for_pages(size_t pages) {
    const auto texels =
        static_cast<uint64_t>(kAllHalvings * static_cast<double>(pages * kSheetTexelsMax));
    const auto threads = static_cast<uint64_t>(thread_count());
    return ask(arrays_in_memory_ + threads * kBytesPerThread,
               arrays_in_files_ + texels * sizeof(Rgba8), texels);
  }

 private:
  Status ask(uint64_t memory_bytes, uint64_t scratch_bytes, uint64_t file_bytes) {
    need_.memory_bytes = held_bytes_ + memory_bytes;
    need_.scratch_bytes = scratch_bytes;
    need_.file_bytes = file_bytes;
    return budget_.ask(need_).with_context("making sheets of " +
                                           std::to_string(need_.counts.triangles) + " triangles");
  }

  const ScratchSpace& space_;
  PreparationBudget& budget_;
  PreparationNeed need_;
  uint64_t held_bytes_ = 0;
  uint64_t arrays_in_memory_ = 0;
  uint64_t arrays_in_files_ = 0;
};

/// The sheets of a page on their way to the file.
struct EncodedPage {
  std::vector<uint8_t> charts;
  std::vector<std::vector<uint8_t>> sheets;
  Status status;
  uint64_t texels = 0;
  double used_texels = 0;
  uint64_t lost_triangles = 0;
};

/// Makes the sheets of pages, of level 0 and of those above.
class PageMaker {
 public:
  PageMaker(const SheetsInput& scan, const PictureTiles& tiles, const TriangleFinder& finder)
      : scan_(scan),
        tiles_(tiles),
        finder_(finder),
        step_(scan.pages.directory().head.grid.step()) {}

  /// `finer`: the level below; null at level 0. `made` keeps the page's sheets.
  EncodedPage make(PageId id, const LevelSheets* finer, LevelSheets& made,
                   const std::function<void()>& ask) const {
    EncodedPage encoded;
    encoded.status = fill(encoded, id, finer, made, ask);
    return encoded;
  }

 private:
  Status fill(EncodedPage& encoded, PageId id, const LevelSheets* finer, LevelSheets& made,
              const std::function<void()>& ask) const {
    ASSIGN_OR_RETURN(const Page page, scan_.pages.read_page(id));
    auto sheets = finer == nullptr ? paint(encoded, page, ask) : join(page, *finer, ask);
    RETURN_IF_ERROR(sheets.status());
    encoded.texels = sheets->texels();
    encoded.charts = encode_charts(id, sheets->charts);
    for (const Sheet& sheet : sheets->sheets) {
      ask();
      ASSIGN_OR_RETURN(auto bytes, encode_sheet(sheet));
      encoded.sheets.push_back(std::move(bytes));
    }
    return made.keep(std::move(sheets->charts), sheets->sheets);
  }

  /// Makes sheets of level 0 from the pictures.
  Result<PageSheets> paint(EncodedPage& encoded, const Page& page,
                           const std::function<void()>& ask) const {
    const PagePaint paint(page, scan_.surface, tiles_, finder_);
    encoded.used_texels = paint.used_texels();
    encoded.lost_triangles = paint.lost_triangles();
    PictureSampler sampler(tiles_);
    const double native = painted_density(page, paint);
    PageSheetsWish wish{.step = step_, .ask = ask};
    wish.density = std::min(native, std::sqrt(kSheetTexelsMax / page_area(page, step_)));
    // Pictures that do not fit on a sheet have two texels for one of it in places.
    wish.samples_per_side = wish.density < native ? 2 : 1;
    wish.source = [&](double density) -> Result<BakeSource> {
      return paint.source(sampler, density * step_);
    };
    auto made = make_page_sheets(page, wish);
    RETURN_IF_ERROR(sampler.status());
    return made;
  }

  /// Returns the density of a page's pictures. A page without any gets what a coarse page has.
  double painted_density(const Page& page, const PagePaint& paint) const {
    const size_t triangles = page.triangles.size();
    const double area = page_area(page, step_);
    if (paint.painted_area() <= 0) return edge_density(kTexelsPerEdge, triangles, area);
    const double native = native_density(paint.used_texels(), paint.painted_area() * step_ * step_);
    return std::max(native, edge_density(kTexelsPerEdge / 4, triangles, area));
  }

  /// Makes sheets of a coarser level from those of the pages that it replaces.
  Result<PageSheets> join(const Page& page, const LevelSheets& finer,
                          const std::function<void()>& ask) const {
    std::vector<Page> pages;
    std::vector<double> densities;
    for (const PagePatch& patch : page.patches) {
      ASSIGN_OR_RETURN(pages.emplace_back(), scan_.pages.read_page(patch.finer));
      densities.push_back(finer.density(patch.finer));
    }
    std::vector<Sheet> sheets;
    PageSheetsWish wish{.step = step_, .samples_per_side = 2, .ask = ask};
    wish.density = coarse_density(densities, page.triangles.size(), page_area(page, step_));
    wish.source = [&](double density) -> Result<BakeSource> {
      sheets.reserve(pages.size());  // the source keeps pointers
      std::vector<SheetedPage> sheeted;
      for (const Page& replaced : pages) {
        ASSIGN_OR_RETURN(sheets.emplace_back(), finer.read(replaced.id, density));
        sheeted.push_back({&replaced, &finer.charts(replaced.id), &sheets.back()});
      }
      return source_of_sheets(sheeted, step_);
    };
    return make_page_sheets(page, wish);
  }

  const SheetsInput& scan_;
  const PictureTiles& tiles_;
  const TriangleFinder& finder_;
  const double step_;
};

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
    ask_before(loop_);
    const TriangleFinder finder(scan_.surface.mesh, head().grid, options_.space);
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
    const std::function<void()> ask = [&] {
      if (!loop_.goes_on(static_cast<double>(begin) / head().page_count())) leave_cancelled_work();
    };
    parallel_pages(begin, end, head().page_count(), loop_, [&](size_t page) {
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
  SheetsNeed need(scan, options, budget);
  return SheetsBuilder(scan, path, options, need, progress, filled).build();
} catch (const WorkCancelled&) {
  return cancelled("making sheets was cancelled");
} catch (const ScratchFull& full) {
  return resource_exhausted("making sheets: " + std::string(full.what()));
} catch (const std::bad_alloc&) {
  return resource_exhausted("making sheets: not enough memory");
}

}  // namespace burnish
