// Pages of whole scans: what they take to build, what they weigh, and whether random cuts of them
// have cracks.

#include <ctime>
#include <filesystem>
#include <unistd.h>

#include "server/prepare/pages/build_pages.h"
#include "tests/bench/bench_main.h"
#include "tests/bench/timing.h"
#include "tests/server/prepare/pages/crack_finder.h"
#include "tests/server/prepare/pages/random_cut.h"

namespace burnish {
namespace {

constexpr uint32_t kCuts = 1000;

struct Tables {
  BenchTable& scans;
  BenchTable& levels;
  BenchTable& phases;
  BenchTable& cuts;
};

/// The place of a page file, which goes with this object.
struct ScratchFile {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("burnish-pages-bench-" + std::to_string(getpid()));

  ~ScratchFile() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
};

double number(uint64_t count) {
  return static_cast<double>(count);
}

// Of all threads.
double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void add_levels(const std::string& name, const PagesReport& pages, BenchTable& table) {
  for (size_t level = 0; level < pages.levels.size(); ++level) {
    const PagesReport::Level& l = pages.levels[level];
    table.add({name, number(level), number(l.triangles), number(l.pages),
               number(l.triangles) / number(l.pages), number(l.vertices) / number(l.pages),
               100 * number(l.border_vertices) / number(l.vertices),
               number(l.bytes) / number(l.triangles), number(l.clustered_pages),
               number(l.torn_pages)});
  }
}

void add_scan(const std::string& name, const TriangleMesh& mesh, const PagesReport& pages,
              double seconds, double file_bytes, BenchTable& table) {
  PagesReport::Level all;
  for (const PagesReport::Level& level : pages.levels) {
    all.triangles += level.triangles;
    all.pages += level.pages;
    all.bytes += level.bytes;
    all.vertices += level.vertices;
    all.border_vertices += level.border_vertices;
  }
  const double triangles = number(mesh.triangles.size());
  table.add({name, triangles, number(pages.levels.size()), number(all.pages),
             number(all.bytes) / number(all.triangles), file_bytes / triangles,
             triangles / seconds * 1e-6, number(pages.levels.back().triangles),
             number(pages.levels.back().bytes),
             100 * number(all.border_vertices) / number(all.vertices)});
}

Status check_cuts(const std::string& name, const std::filesystem::path& path, BenchTable& table) {
  ASSIGN_OR_RETURN(const ReadPages read, read_pages(path));
  const CrackFinder finder(read, 1);
  size_t cracks = 0, pages = 0;
  for (uint32_t seed = 0; seed < kCuts; ++seed) {
    const PageSet cut = random_legal_cut(read.directory, seed);
    cracks += finder.count_cracks(cut);
    pages += static_cast<size_t>(std::ranges::count(cut, 1));
  }
  table.add({name, kCuts, number(pages) / kCuts, number(finder.count_misfits()), number(cracks)});
  return Status::ok();
}

Status report_scan(const ScanArgument& scan, Tables& tables) {
  ASSIGN_OR_RETURN(const TriangleMesh mesh, load_mesh(scan));
  const ScratchFile file;
  PagesReport pages;
  const double start = processor_seconds();
  RETURN_IF_ERROR(build_pages_of(mesh, file.path, {}, {}, &pages));
  const double seconds = processor_seconds() - start;
  add_scan(scan.name(), mesh, pages, seconds, number(std::filesystem::file_size(file.path)),
           tables.scans);
  add_levels(scan.name(), pages, tables.levels);
  for (const PagesReport::Phase& phase : pages.phases)
    tables.phases.add({scan.name(), phase.name, phase.seconds});
  return check_cuts(scan.name(), file.path, tables.cuts);
}

Status run(const BenchArguments& arguments, BenchReport& report) {
  Tables tables{
      report.add_table("page_scans", {{"scan", "", 18},
                                      {"triangles", "%.0f"},
                                      {"levels", "%.0f"},
                                      {"pages", "%.0f"},
                                      {"bytes_per_page_triangle", "%.2f"},
                                      {"bytes_per_scan_triangle", "%.2f"},
                                      {"mtriangles_per_core_s", "%.2f"},
                                      {"root_triangles", "%.0f"},
                                      {"root_bytes", "%.0f"},
                                      {"border_percent", "%.1f"}}),
      report.add_table("page_levels", {{"scan", "", 18},
                                       {"level", "%.0f"},
                                       {"triangles", "%.0f"},
                                       {"pages", "%.0f"},
                                       {"triangles_per_page", "%.0f"},
                                       {"vertices_per_page", "%.0f"},
                                       {"border_percent", "%.1f"},
                                       {"bytes_per_triangle", "%.2f"},
                                       {"clustered_pages", "%.0f"},
                                       {"torn_pages", "%.0f"}}),
      report.add_table("page_phases", {{"scan", "", 18}, {"phase", "", 12}, {"seconds", "%.3f"}}),
      report.add_table("page_cuts", {{"scan", "", 18},
                                     {"cuts", "%.0f"},
                                     {"pages_per_cut", "%.1f"},
                                     {"misfits", "%.0f"},
                                     {"cracks", "%.0f"}})};
  for (const ScanArgument& scan : arguments.scans) RETURN_IF_ERROR(report_scan(scan, tables));
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::bench_main(
      {"pages_bench", {"tablet:1000000", "blob:1000000", "soup:300000"}, burnish::run}, argc, argv);
}
