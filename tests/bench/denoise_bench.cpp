// Measures denoising that keeps edges: errors of normals and places for each shape, noise and
// preset, of the layer alone and of whole filters; triangles that turn over on odd scans; and CPU
// seconds. denoise_bench [--out FOLDER] [MESH]... Mesh files are tried as odd scans.
// denoise_bench --shapes FOLDER writes the shapes, with and without noise, and our results.
// denoise_bench --measure CLEAN MESH... prints the errors of other results.
// denoise_bench --live [SCAN:VERTICES]... times filters of processors and, where there is one, of a
// device.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/parallel.h"
#include "common/denoise/denoise.h"
#include "common/denoise/normal_filter.h"
#include "common/denoise/normal_layer.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/bench/denoise_filter.h"
#include "tests/bench/denoise_live.h"
#include "tests/bench/denoise_shapes.h"
#include "tests/bench/report.h"
#include "tests/bench/timing.h"
#include "tests/common/denoise/shape_error.h"

namespace burnish {
namespace {

struct Arguments {
  std::string out, shapes;
  bool measures = false, live = false;
  std::vector<std::string> meshes;
};

/// A clean shape, what noise it gets, and which preset is for it.
struct Case {
  const char* kind;
  uint64_t vertices;
  const char* noise;
  double deviation;  // over the mean edge
  const char* preset;
};
constexpr Case kCases[] = {
    {"part", 7000, "gauss", 0.1, "machined"},   {"part", 7000, "gauss", 0.2, "machined"},
    {"part", 7000, "gauss", 0.3, "machined"},   {"part", 7000, "scanner", 0.15, "scanner"},
    {"coin", 14400, "gauss", 0.05, "relief"},   {"coin", 14400, "gauss", 0.1, "relief"},
    {"coin", 14400, "gauss", 0.2, "relief"},    {"coin", 14400, "scanner", 0.15, "relief"},
    {"icosphere", 10242, "gauss", 0.2, "soft"}, {"blob", 12000, "gauss", 0.2, "soft"},
    {"tablet", 30000, "gauss", 0.05, "relief"}, {"tablet", 30000, "range", 0.2, "relief"},
};

double cpu_seconds() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Seconds of a piece of work, by all processors and on the clock.
struct Cost {
  double cpu = 0, wall = 0;
};

template <typename Work>
Cost cost_of(const Work& work) {
  const double before = cpu_seconds();
  const double wall = milliseconds(work) * 1e-3;
  return {cpu_seconds() - before, wall};
}

TriangleMesh shape_of(const Case& of, double deviation) {
  return *generate_scan({of.kind, of.vertices, 1, deviation, *parse_noise_kind(of.noise)});
}

std::string noise_of(const Case& of) {
  return of.noise + std::string(" ") + in_words("%g", of.deviation);
}

Result<NoisyShape> noisy_shape(const Case& of) {
  ASSIGN_OR_RETURN(const EdgePreset preset, find_edge_preset(of.preset));
  return NoisyShape{of.kind, noise_of(of), shape_of(of, 0), shape_of(of, of.deviation), preset};
}

void add_error(const Case& of, const std::string& method, const TriangleMesh& clean,
               const TriangleMesh& noisy, const TriangleMesh& mesh, double seconds,
               BenchTable& table) {
  const ShapeError error = shape_error(clean, mesh);
  table.add({std::string(of.kind), noise_of(of), method, error.angle, error.distance, error.volume,
             100 * turned_share(noisy, mesh),
             1e6 * seconds / static_cast<double>(mesh.triangles.size())});
}

Status report_case(const Case& of, BenchTable& table) {
  const TriangleMesh clean = shape_of(of, 0), noisy = shape_of(of, of.deviation);
  add_error(of, "noisy", clean, noisy, noisy, 0, table);
  for (const EdgePreset& preset : edge_presets()) {
    std::vector<Vec3f> layer;
    Status status;
    const Cost cost = cost_of([&] {
      auto surface = make_denoise_surface(noisy);
      auto made = surface.is_ok() ? denoise_layer(**surface, preset.filter) : surface.status();
      status = made.status();
      if (made.is_ok()) layer = *std::move(made);
    });
    RETURN_IF_ERROR(status);
    add_error(of, std::string(preset.name), clean, noisy, moved(noisy, layer), cost.cpu, table);
  }
  return Status::ok();
}

Status report_odd(const std::string& name, const TriangleMesh& mesh, BenchTable& table) {
  ASSIGN_OR_RETURN(const auto surface, make_denoise_surface(mesh));
  for (const EdgePreset& preset : edge_presets()) {
    ASSIGN_OR_RETURN(const std::vector<Vec3f> layer, denoise_layer(*surface, preset.filter));
    const auto infinite = std::count_if(layer.begin(), layer.end(),
                                        [](const Vec3f& move) { return !move.allFinite(); });
    table.add({name, std::string(preset.name), static_cast<double>(mesh.triangles.size()),
               static_cast<double>(infinite), 100 * turned_share(mesh, moved(mesh, layer))});
  }
  return Status::ok();
}

void report_steps(NormalFilterKind kind, const DenoiseSurface& surface, double millions,
                  BenchTable& table) {
  const auto add = [&](const char* step, const Cost& cost) {
    table.add(
        {std::string(name_of(kind)), std::string(step), cost.cpu / millions, cost.wall / millions});
  };
  std::optional<NormalFilter> filter;
  add("weights", cost_of([&] { filter.emplace(surface.welded, surface.rings, kind, 0.3); }));
  add("restart", cost_of([&] { filter->restart(0.35); }));
  add("pass", cost_of([&] { filter->pass(); }));
  add("layer of 5 updates",
      cost_of([&] { normal_layer(surface.welded, filter->normals(), {.updates = 5}); }));
  add("layer", cost_of([&] { normal_layer(surface.welded, filter->normals()); }));
  for (const EdgePreset& preset : edge_presets())
    if (preset.filter.kind == kind)
      add(std::string(preset.name).c_str(), cost_of([&] {
            BURNISH_CHECK(denoise_layer(surface, preset.filter).is_ok(), "the layer is made");
          }));
}

Status report_times(BenchTable& table) {
  ASSIGN_OR_RETURN(const TriangleMesh mesh, generate_scan({"tablet", 500'000, 1, 0.2}));
  const double millions = 1e-6 * static_cast<double>(mesh.triangles.size());
  std::shared_ptr<const DenoiseSurface> surface;
  const Cost made = cost_of([&] { surface = *make_denoise_surface(mesh); });
  table.add({std::string("both"), std::string("rings"), made.cpu / millions, made.wall / millions});
  for (const auto kind : {NormalFilterKind::kBilateral, NormalFilterKind::kEdges})
    report_steps(kind, *surface, millions, table);
  return Status::ok();
}

using ReportShape = Status (*)(const NoisyShape&, BenchTable&);

Status report_shapes(const char* name, ReportShape report_shape, BenchReport& report) {
  BenchTable& table = report.add_table(name, {{"shape", "", 10},
                                              {"noise", "", 13},
                                              {"method", "", 26},
                                              {"angle_degrees", "%.2f"},
                                              {"rms_edges", "%.3f"},
                                              {"volume_percent", "%.2f"},
                                              {"turned_percent", "%.3f"}});
  for (const Case& of : kCases) {
    ASSIGN_OR_RETURN(const NoisyShape shape, noisy_shape(of));
    RETURN_IF_ERROR(report_shape(shape, table));
  }
  return Status::ok();
}

Status report_all(const Arguments& arguments, BenchReport& report) {
  BenchTable& errors = report.add_table("errors", {{"shape", "", 10},
                                                   {"noise", "", 13},
                                                   {"method", "", 26},
                                                   {"angle_degrees", "%.2f"},
                                                   {"rms_edges", "%.3f"},
                                                   {"volume_percent", "%.2f"},
                                                   {"turned_percent", "%.3f"},
                                                   {"cpu_s_per_million", "%.2f"}});
  for (const Case& of : kCases) RETURN_IF_ERROR(report_case(of, errors));
  RETURN_IF_ERROR(report_shapes("whole filters", report_filtered, report));
  RETURN_IF_ERROR(report_shapes("sharpened by 3", report_sharpened, report));
  BenchTable& odd = report.add_table("odd scans", {{"scan", "", 18},
                                                   {"method", "", 26},
                                                   {"triangles", "%.0f"},
                                                   {"infinite_moves", "%.0f"},
                                                   {"turned_percent", "%.4f"}});
  for (const char* kind : {"wall", "soup", "fan", "sheets"}) {
    ASSIGN_OR_RETURN(const TriangleMesh mesh, generate_scan({kind, 50'000}));
    RETURN_IF_ERROR(report_odd(kind, mesh, odd));
  }
  for (const std::string& path : arguments.meshes) {
    ASSIGN_OR_RETURN(const TriangleMesh mesh, read_mesh(path));
    RETURN_IF_ERROR(report_odd(std::filesystem::path(path).stem(), mesh, odd));
  }
  report.remark(std::to_string(thread_count()) + " threads");
  return report_times(report.add_table(
      "seconds per million triangles",
      {{"filter", "", 10}, {"step", "", 26}, {"cpu_seconds", "%.3f"}, {"seconds", "%.3f"}}));
}

Status write_shapes(const std::string& folder) {
  for (const Case& of : kCases) {
    ASSIGN_OR_RETURN(const NoisyShape shape, noisy_shape(of));
    RETURN_IF_ERROR(write_shape(shape, folder));
  }
  return Status::ok();
}

Status run(const Arguments& arguments) {
  if (arguments.measures) return print_errors(arguments.meshes);
  if (!arguments.shapes.empty()) return write_shapes(arguments.shapes);
  BenchReport report("denoise_bench");
  RETURN_IF_ERROR(arguments.live ? report_live(arguments.meshes, report)
                                 : report_all(arguments, report));
  if (arguments.out.empty()) return Status::ok();
  std::filesystem::create_directories(arguments.out);
  return report.write(arguments.out);
}

Arguments parsed(int count, char** words) {
  Arguments arguments;
  for (int i = 1; i < count; ++i) {
    if (words[i] == std::string_view("--out") && i + 1 < count)
      arguments.out = words[++i];
    else if (words[i] == std::string_view("--shapes") && i + 1 < count)
      arguments.shapes = words[++i];
    else if (words[i] == std::string_view("--measure"))
      arguments.measures = true;
    else if (words[i] == std::string_view("--live"))
      arguments.live = true;
    else
      arguments.meshes.emplace_back(words[i]);
  }
  return arguments;
}

}  // namespace
}  // namespace burnish

int main(int count, char** words) {
  const burnish::Status status = burnish::run(burnish::parsed(count, words));
  if (!status.is_ok()) std::fprintf(stderr, "denoise_bench: %s\n", status.message().c_str());
  return status.is_ok() ? 0 : 1;
}
