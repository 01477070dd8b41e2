#include "tests/bench/input.h"

#include <charconv>
#include <cmath>
#include <filesystem>

#include "common/base/process_memory.h"
#include "common/generate/generate.h"
#include "common/grid/depth_plan.h"
#include "common/grid/grid.h"
#include "common/mesh/io/mesh_io.h"
#include "common/mesh/statistics/statistics.h"
#include "server/prepare/prepare.h"
#include "server/solver/tuning/plan_cycle.h"
#include "tests/bench/report.h"

namespace burnish {

namespace {

// A plane of unit area meets 1.5 cells on average over its directions. A cell of a surface has two
// corners of its own.
constexpr double kCornersPerCellArea = 3;
// Bytes of integrals, hierarchy and one session per corner, and of preparing beyond the mesh.
constexpr double kBytesPerCorner = 1400;
constexpr double kBytesPerVertex = 200;

template <typename Number>
bool parse_number(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

std::string ScanArgument::name() const {
  return scan.find(':') != std::string::npos ? scan : std::filesystem::path(scan).stem().string();
}

Result<ScanArgument> parse_scan(std::string_view text) {
  const size_t at = text.rfind('@');
  ScanArgument argument{.scan = std::string(text.substr(0, at))};
  if (at == std::string_view::npos) return argument;
  const std::string_view depth = text.substr(at + 1);
  if (!parse_number(depth, argument.depth) || argument.depth < kDepthMin ||
      argument.depth > kDepthMax)
    return invalid_argument("depth '" + std::string(depth) + "' of '" + std::string(text) +
                            "' is outside " + std::to_string(kDepthMin) + ".." +
                            std::to_string(kDepthMax));
  return argument;
}

Result<TriangleMesh> load_mesh(const ScanArgument& scan) {
  const size_t colon = scan.scan.find(':');
  if (colon == std::string::npos) return read_mesh(scan.scan);
  GeneratedScan generated{.kind = scan.scan.substr(0, colon)};
  std::string_view numbers = std::string_view(scan.scan).substr(colon + 1);
  const std::string_view count = numbers.substr(0, numbers.find(':'));
  if (!parse_number(count, generated.vertices))
    return invalid_argument("'" + std::string(count) + "' of '" + scan.scan +
                            "' is not a number of vertices");
  if (count.size() == numbers.size()) return generate_scan(generated);
  numbers.remove_prefix(count.size() + 1);
  double stretch = 0;
  if (!parse_number(numbers, stretch) || !(stretch > 0))
    return invalid_argument("'" + std::string(numbers) + "' of '" + scan.scan +
                            "' is not a stretch above 0");
  ASSIGN_OR_RETURN(TriangleMesh mesh, generate_scan(generated));
  for (Vec3d& vertex : mesh.vertices) vertex.z() *= stretch;
  return mesh;
}

int depth_of(const ScanArgument& scan, const TriangleMesh& mesh) {
  if (scan.depth > 0) return scan.depth;
  return default_depth(compute_statistics(mesh), memory_of_default_depth(machine_memory_bytes()));
}

Status check_size(const std::string& name, const TriangleMesh& mesh, int depth,
                  double corners_max) {
  const MeshStatistics statistics = compute_statistics(mesh);
  const GridFrame frame = make_grid_frame(statistics.box_min, statistics.box_max, depth);
  const double corners =
      kCornersPerCellArea * statistics.area / (frame.cell_size * frame.cell_size);
  if (corners > corners_max)
    return resource_exhausted(name + ": about " + in_words("%.1e", corners) +
                              " corners, the limit is " + in_words("%.1e", corners_max));
  const double bytes =
      kBytesPerCorner * corners + kBytesPerVertex * static_cast<double>(mesh.vertices.size());
  const double available = static_cast<double>(available_memory_bytes());
  if (bytes > available)
    return resource_exhausted(name + ": needs about " + in_words("%.1f", bytes * 1e-9) +
                              " GB of memory, " + in_words("%.1f", available * 1e-9) +
                              " GB are free");
  return Status::ok();
}

Result<BenchSystem> make_system(const ScanArgument& scan, const TriangleMesh& mesh, int depth,
                                double corners_max) {
  BenchSystem system;
  system.name = scan.name() + "@" + std::to_string(depth);
  RETURN_IF_ERROR(check_size(system.name, mesh, depth, corners_max));
  ASSIGN_OR_RETURN(const auto prepared, prepare(mesh, {.depth = depth}));
  ASSIGN_OR_RETURN(static_cast<Multigrid&>(system), make_multigrid(prepared));
  return system;
}

}  // namespace burnish
