#include "tests/bench/denoise_live.h"

#include <filesystem>
#include <memory>
#include <string_view>
#include <utility>

#include "common/base/check.h"
#include "common/base/parallel.h"
#include "common/base/text_lines.h"
#include "common/denoise/surface_filter.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "common/mesh/triangle_mesh.h"
#include "server/solver/cuda/cuda_backend.h"
#include "server/solver/cuda/cuda_filter.h"
#include "tests/bench/timing.h"

namespace burnish {
namespace {

struct Scan {
  std::string name;
  TriangleMesh mesh;
  std::shared_ptr<const DenoiseSurface> surface;
};

Result<TriangleMesh> mesh_of(const std::string& words) {
  if (std::filesystem::exists(words)) return read_mesh(words);
  const size_t colon = words.find(':');
  if (colon == std::string::npos)
    return invalid_argument("no file and not KIND:VERTICES: " + words);
  ASSIGN_OR_RETURN(const int vertices, parse_integer(std::string_view(words).substr(colon + 1)));
  return generate_scan({words.substr(0, colon), static_cast<uint64_t>(vertices), 1, 0.2});
}

Result<Scan> scan_of(const std::string& words) {
  Scan scan{std::filesystem::path(words).stem(), {}, {}};
  ASSIGN_OR_RETURN(scan.mesh, mesh_of(words));
  ASSIGN_OR_RETURN(scan.surface, make_denoise_surface(scan.mesh));
  return scan;
}

/// A filter, and how long it took to make.
struct Made {
  std::unique_ptr<SurfaceFilter> filter;
  double milliseconds = 0;
};

Result<Made> made_on(bool device, const Scan& scan) {
  Made made;
  Status status;
  made.milliseconds = milliseconds([&] {
    if (!device) {
      made.filter = make_processor_filter(scan.surface);
      return;
    }
    auto there = make_cuda_filter(scan.surface);
    status = there.status();
    if (status.is_ok()) made.filter = std::move(there).value();
  });
  RETURN_IF_ERROR(status);
  return made;
}

FilteredSurface must_filter(SurfaceFilter& filter, const EdgeFilter& wanted) {
  auto filtered = filter.filter(wanted);
  BURNISH_CHECK(filtered.is_ok(), "a surface could not be filtered");
  return std::move(filtered).value();
}

/// Returns the median milliseconds of a filter of another angle each time.
double of_a_drag(SurfaceFilter& filter, EdgeFilter wanted, int repeats) {
  return median_milliseconds(repeats, 1, [&] {
    wanted.edge_angle += 0.5;
    must_filter(filter, wanted);
  });
}

/// `expected`: the processors' result.
Status add_row(const Scan& scan, const EdgePreset& preset, bool device,
               const FilteredSurface& expected, BenchTable& table) {
  const int repeats = device ? 15 : 3;
  ASSIGN_OR_RETURN(const Made made, made_on(device, scan));
  SurfaceFilter& filter = *made.filter;
  EdgeFilter longer = preset.filter;
  longer.passes *= 2;
  FilteredSurface found;
  const double first = milliseconds([&] { found = must_filter(filter, preset.filter); });
  const double again = of_a_drag(filter, preset.filter, repeats);
  const double pass = (of_a_drag(filter, longer, repeats) - again) / preset.filter.passes;
  const bool is_same = found.normals == expected.normals && found.layer == expected.layer;
  table.add(
      {scan.name, static_cast<double>(scan.mesh.triangles.size()), std::string(preset.name),
       std::string(device ? "cuda" : "cpu"), made.milliseconds, first, again, pass,
       again - pass * preset.filter.passes,
       static_cast<double>(filter.byte_count()) / static_cast<double>(scan.mesh.triangles.size()),
       std::string(is_same ? "yes" : "NO")});
  return Status::ok();
}

Status add_rows(const std::string& words, BenchTable& table) {
  ASSIGN_OR_RETURN(const Scan scan, scan_of(words));
  for (const char* name : {"scanner", "machined"}) {
    ASSIGN_OR_RETURN(const EdgePreset preset, find_edge_preset(name));
    const FilteredSurface expected =
        must_filter(*make_processor_filter(scan.surface), preset.filter);
    RETURN_IF_ERROR(add_row(scan, preset, false, expected, table));
    if (cuda_device().is_ok()) RETURN_IF_ERROR(add_row(scan, preset, true, expected, table));
  }
  return Status::ok();
}

}  // namespace

// "make" copies the surface, "first" also weighs pairs; "rest" is the layer with the copy to the
// host.
Status report_live(std::span<const std::string> scans, BenchReport& report) {
  report.remark(std::to_string(thread_count()) + " threads; " +
                (cuda_device().is_ok() ? *cuda_device() : cuda_device().status().message()));
  BenchTable& table = report.add_table("live filter", {{"scan", "", 16},
                                                       {"triangles", "%.0f", 9},
                                                       {"preset", "", 9},
                                                       {"on", "", 5},
                                                       {"make_ms", "%.1f", 8},
                                                       {"first_ms", "%.1f", 8},
                                                       {"again_ms", "%.2f", 8},
                                                       {"pass_ms", "%.3f", 8},
                                                       {"rest_ms", "%.2f", 8},
                                                       {"bytes_a_triangle", "%.0f"},
                                                       {"same_bits", "", 4}});
  if (scans.empty()) return add_rows("tablet:500000", table);
  for (const std::string& scan : scans) RETURN_IF_ERROR(add_rows(scan, table));
  return Status::ok();
}

}  // namespace burnish
