#include "server/prepare/pages/build_pages.h"

#include <algorithm>
#include <chrono>
#include <new>

#include "common/base/parallel.h"
#include "common/mesh/agreeing_vertices.h"
#include "server/prepare/pages/level_writer.h"
#include "server/prepare/pages/pages_need.h"

namespace burnish {

namespace {

constexpr double kReplaceShare = 0.45;             // of the time of a level; writing takes the rest
constexpr size_t kTrianglesForSimplifying = 1024;  // of a page: smaller ones are mostly border

/// One level of the surface while its pages are made.
struct Level {
  int number = 0;                    ///< 0: the scan itself
  ScratchArray<Triangle> triangles;  ///< vertices of the scan
  ScratchArray<PageId> finer;        ///< per triangle, rising; empty at level 0
  ScratchArray<float> texels;        ///< per triangle, of pictures; empty: they do not matter
  double vertices_per_triangle = 0.5;
};

/// Adds up the seconds of each phase over all levels.
class PhaseTimes {
 public:
  explicit PhaseTimes(PagesReport& report) : report_(report) {}

  void end(const char* name) {
    const auto now = std::chrono::steady_clock::now();
    auto phase = std::ranges::find(report_.phases, name, &PagesReport::Phase::name);
    if (phase == report_.phases.end()) phase = report_.phases.insert(phase, {name});
    phase->seconds += std::chrono::duration<double>(now - start_).count();
    start_ = now;
  }

 private:
  PagesReport& report_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Lets vertices that look alike at one place be one, so that a seam has no line and a soup is
/// shaded as a surface. Returns how many vertices have lost their triangles.
uint64_t join_vertices(const PagesInput& scan, std::span<Triangle> triangles,
                       const ScratchSpace& space, const LoopPart& part) {
  MeshView mesh;
  mesh.vertices = scan.vertices;
  mesh.triangles = scan.triangles;
  mesh.colours = scan.colours;
  const ScratchArray<uint32_t> least = least_that_agree(mesh, space, part);
  uint64_t joined = 0;
  for (uint32_t v = 0; v < least.size(); ++v) joined += least[v] != v;
  if (joined > 0)
    for_each_heard(part, triangles.size(), [&](size_t t) {
      for (uint32_t& vertex : triangles[t]) vertex = least[vertex];
    });
  return joined;
}

Level make_level_0(const PagesInput& scan, const ScratchSpace& space, const LoopPart& part) {
  Level level;
  level.triangles = copy_to(space, scan.triangles);
  level.texels = copy_to(space, scan.texels.of_triangle);
  const uint64_t joined =
      join_vertices(scan, {level.triangles.data(), level.triangles.size()}, space, part);
  size_t kept = 0;
  for_each_heard(part, level.triangles.size(), [&](size_t i) {
    const Triangle t = level.triangles[i];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
    if (!level.texels.empty()) level.texels[kept] = level.texels[i];
    level.triangles[kept++] = t;
  });
  level.triangles.truncate(kept);
  if (!level.texels.empty()) level.texels.truncate(kept);
  const auto referenced =
      static_cast<double>(scan.statistics.vertices - scan.statistics.unreferenced_vertices) -
      static_cast<double>(joined);
  // Pages share vertices, so together they have more than the scan.
  level.vertices_per_triangle =
      1.06 * std::max(referenced, 1.0) / static_cast<double>(level.triangles.size());
  return level;
}

Level make_coarser(const Level& level, const PagesReport::Level& report,
                   const Replacements& replacements, PageId first_page, const ScratchSpace& space) {
  Level coarser;
  coarser.number = level.number + 1;
  uint64_t count = 0;
  for (const Replacement& replacement : replacements.of_pages) count += replacement.count;
  coarser.triangles = ScratchArray<Triangle>(space, count);
  coarser.finer = ScratchArray<PageId>(space, count);
  uint64_t next = 0;
  for (size_t page = 0; page < replacements.of_pages.size(); ++page) {
    std::ranges::copy(replacements.of(page), coarser.triangles.begin() + next);
    const uint64_t end = next + replacements.of_pages[page].count;
    std::fill(coarser.finer.begin() + next, coarser.finer.begin() + end,
              first_page + static_cast<PageId>(page));
    next = end;
  }
  coarser.vertices_per_triangle =
      static_cast<double>(report.vertices) / static_cast<double>(report.triangles);
  return coarser;
}

class PagesBuilder {
 public:
  PagesBuilder(const PagesInput& scan, const ScratchSpace& space, const Progress& progress,
               PagesReport& report)
      : scan_(scan), space_(space), progress_(progress), report_(report), times_(report) {}

  Status build(PageFileWriter& file) {
    vertices_ = place_vertices(scan_, space_, part());
    times_.end("vertices");
    LevelWriter writer(file, vertices_, attributes_);
    for (Level level = make_level_0(scan_, space_, part()); !level.triangles.empty();) {
      ASSIGN_OR_RETURN(level, make_level(level, file, writer));
    }
    const Status status = file.finish();
    times_.end("writing");
    return status;
  }

 private:
  // Returns the next level, or one without triangles after the root.
  Result<Level> make_level(const Level& level, PageFileWriter& file, LevelWriter& writer) {
    const PageGroups pages =
        cut_pages({level.triangles, vertices_.positions, vertices_.grid.bits, level.number,
                   level.vertices_per_triangle, PageTexels{level.texels, scan_.texels.of_page_max}},
                  space_, part());
    const CutLevel cut = {level.triangles, vertices_.joined, pages};
    const ScratchArray<uint8_t> shared = find_shared_vertices(cut, space_, part());
    report_.levels.push_back({level.triangles.size(), pages.count()});
    times_.end("cutting");
    if (level.number == 0) {
      attributes_ = make_scan_attributes(scan_, cut, shared, space_, part());
      times_.end("normals");
    }
    Replacements replacements(space_);
    const PageWork replacing = work(kReplaceShare), writing = work(1 - kReplaceShare);
    if (pages.count() > 1) {
      const auto replace = are_small_for_texels(level, pages) ? keep_pages : replace_pages;
      ASSIGN_OR_RETURN(replacements, replace(cut, vertices_, shared, space_, replacing));
    }
    times_.end("simplifying");
    PagesReport::Level& report = report_.levels.back();
    report.clustered_pages = replacements.clustered_pages;
    report.torn_pages = replacements.torn_pages;
    const PageId first_page = file.next_page();
    const LevelToDraw to_draw = {cut, level.finer, shared, vertices_, attributes_};
    RETURN_IF_ERROR(writer.write(to_draw, replacements, writing, space_, report));
    times_.end("writing");
    return make_coarser(level, report, replacements, first_page, space_);
  }

  static bool are_small_for_texels(const Level& level, const PageGroups& pages) {
    return !level.texels.empty() &&
           level.triangles.size() < kTrianglesForSimplifying * pages.count();
  }

  // Work between the pages.
  LoopPart part() const { return {progress_, "pages", std::min(done_, 1.0), std::min(done_, 1.0)}; }

  // All levels together have about twice the triangles of the scan.
  PageWork work(double share) {
    const double begin = done_;
    done_ += share / 2 * static_cast<double>(report_.levels.back().triangles) /
             static_cast<double>(report_.levels.front().triangles);
    return {progress_, std::min(begin, 1.0), std::min(done_, 1.0)};
  }

  const PagesInput& scan_;
  const ScratchSpace& space_;
  const Progress& progress_;
  PagesReport& report_;
  PhaseTimes times_;
  PageVertices vertices_;
  VertexAttributes attributes_;  ///< of the level that is made
  double done_ = 0;
};

}  // namespace

Status build_pages(const PagesInput& scan, const std::filesystem::path& path,
                   const PagesOptions& options, const Progress& progress, PagesReport* report) try {
  use_threads(options.threads);
  MachineBudget machine;
  PreparationBudget& budget = options.budget != nullptr ? *options.budget : machine;
  const PreparationNeed need = predict_pages(scan, options.space.memory_bytes_max());
  RETURN_IF_ERROR(budget.ask(need).with_context(pages_need_text(need)));
  PagesReport own_report;
  PagesReport& filled = report != nullptr ? *report : own_report;
  filled = {};
  PagesBuilder builder(scan, options.space, progress, filled);
  const PageScan described = {choose_page_grid(scan.statistics), !scan.colours.empty(),
                              scan.vertices.size(), scan.triangles.size()};
  ASSIGN_OR_RETURN(PageFileWriter file, PageFileWriter::create(path, described));
  return builder.build(file);
} catch (const WorkCancelled&) {
  return cancelled("cancelled while making pages");
} catch (const ScratchFull& full) {
  return resource_exhausted("making pages of a scan of " + std::to_string(scan.triangles.size()) +
                            " triangles: " + full.what());
} catch (const std::bad_alloc&) {
  return resource_exhausted("making pages of a scan of " + std::to_string(scan.triangles.size()) +
                            " triangles: not enough memory");
}

}  // namespace burnish
