// The bytes that a view takes: of a scan, and of the same surface with 16 times the triangles.
//
//   view_bytes_bench [OPTION]... [SCAN]...   see bench_main.h
//
// Views are those of view_bench, without a server and without waiting: errors of 1 pixel and edges
// of 6 at 1280x720, then twice as near. A second table has the errors and edges of all levels, in
// pixels of the whole view.

#include <algorithm>
#include <filesystem>
#include <unistd.h>

#include "client/pages/page_loader.h"
#include "tests/bench/bench_main.h"
#include "tests/bench/local_pages.h"
#include "tests/bench/refined_mesh.h"
#include "tests/server/prepare/pages/read_pages.h"

namespace burnish {
namespace {

constexpr ImageSize kPictureSize{1280, 720};
constexpr double kTrembleDegrees = 1e-3;  // so that full detail does not begin
constexpr int kLooksMax = 10'000;
constexpr size_t kRefinedTrianglesMax = 10'000'000;

struct Tables {
  BenchTable& views;
  BenchTable& levels;
};

/// The bytes that have come for a view.
struct Fetched {
  double kilobytes = 0;
  double triangles = 0;
};

Result<Fetched> fetch_view(LocalPages& pages, Camera camera) {
  const uint64_t before = pages.bytes();
  for (int look = 0; look < kLooksMax; ++look) {
    camera.azimuth_degrees += look % 2 == 0 ? kTrembleDegrees : -kTrembleDegrees;
    RETURN_IF_ERROR(pages.look(make_page_view(camera, kPictureSize, pages.head().grid)).status());
    const PageLoader& loader = pages.loader();
    if (loader.status().reason == CutReason::kMoving && loader.requests().ask.empty())
      return Fetched{static_cast<double>(pages.bytes() - before) / 1e3,
                     static_cast<double>(loader.cut().triangles)};
  }
  return internal_error("the view is not there: " + status_text(pages.loader().status()));
}

// Needs: values.
double part_of(std::vector<double>& values, double part) {
  std::ranges::sort(values);
  return values[static_cast<size_t>(part * static_cast<double>(values.size() - 1))];
}

void add_levels(const std::string& name, const PageDirectory& directory, double pixel,
                BenchTable& table) {
  const PageHead& head = directory.head;
  for (int level = 0; level + 1 < head.level_count(); ++level) {
    std::vector<double> errors, edges;
    for (PageId page = head.level_begin(level); page < head.level_begin(level + 1); ++page) {
      errors.push_back(directory.entries[page].bounds.error / pixel);
      edges.push_back(directory.entries[page].bounds.edge / pixel);
    }
    table.add({name, static_cast<double>(level), static_cast<double>(errors.size()),
               part_of(errors, 0.5), part_of(errors, 0.9), part_of(errors, 1),
               part_of(edges, 0.5)});
  }
}

Status measure(const std::string& name, const TriangleMesh& mesh, Tables& tables) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("burnish-view-bytes-" + std::to_string(getpid()));
  RETURN_IF_ERROR(build_pages_of(mesh, path));
  const auto read = read_pages(path);
  auto file = PageFile::open(path);
  std::filesystem::remove(path);
  RETURN_IF_ERROR(read.status());
  RETURN_IF_ERROR(file.status());
  LocalPages pages(std::move(*file));
  Eigen::AlignedBox3d box;
  for (const Vec3d& vertex : mesh.vertices) box.extend(vertex);
  Camera camera =
      frame_all({.azimuth_degrees = 25, .elevation_degrees = 20}, box, kPictureSize.aspect());
  const PageView view = make_page_view(camera, kPictureSize, pages.head().grid);
  add_levels(name, read->directory, camera.distance / view.pixels_at_one, tables.levels);
  ASSIGN_OR_RETURN(const Fetched whole, fetch_view(pages, camera));
  camera.distance /= 2;
  ASSIGN_OR_RETURN(const Fetched zoomed, fetch_view(pages, camera));
  tables.views.add({name, static_cast<double>(mesh.triangles.size()), whole.kilobytes,
                    whole.triangles, zoomed.kilobytes, zoomed.triangles});
  return Status::ok();
}

Status measure_scan(const ScanArgument& scan, Tables& tables) {
  ASSIGN_OR_RETURN(const TriangleMesh mesh, load_mesh(scan));
  RETURN_IF_ERROR(measure(scan.name(), mesh, tables));
  if (16 * mesh.triangles.size() > kRefinedTrianglesMax) return Status::ok();
  return measure(scan.name() + " refined", refined_mesh(refined_mesh(mesh)), tables);
}

Status run(const BenchArguments& arguments, BenchReport& report) {
  Tables tables{report.add_table("view_bytes", {{"scan", "%s", 32},
                                                {"triangles", "%.0f"},
                                                {"whole_kb", "%.0f"},
                                                {"whole_triangles", "%.0f"},
                                                {"zoom_kb", "%.0f"},
                                                {"zoom_triangles", "%.0f"}}),
                report.add_table("page_errors", {{"scan", "%s", 32},
                                                 {"level", "%.0f"},
                                                 {"pages", "%.0f"},
                                                 {"error_p50_px", "%.3f"},
                                                 {"error_p90_px", "%.3f"},
                                                 {"error_max_px", "%.3f"},
                                                 {"edge_p50_px", "%.2f"}})};
  for (const ScanArgument& scan : arguments.scans) RETURN_IF_ERROR(measure_scan(scan, tables));
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::bench_main(
      {"view_bytes_bench", {"blob:100000", "tablet:250000", "tablet:4000000"}, burnish::run}, argc,
      argv);
}
