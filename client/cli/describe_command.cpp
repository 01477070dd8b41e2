#include <cstdio>
#include <memory>

#include "client/cli/commands.h"
#include "client/cli/depth_table.h"
#include "client/cli/in_range.h"
#include "client/cli/json_output.h"
#include "client/cli/print_json.h"
#include "client/cli/server_option.h"
#include "client/report/depth_text.h"
#include "common/base/limits.h"

namespace burnish {

namespace {

struct DescribeOptions {
  ServerOption server;
  std::string scan;
  int depth = 0;
  bool depths = false;
};

void print_count(const char* what, uint64_t count) {
  std::printf("%-22s %llu\n", what, static_cast<unsigned long long>(count));
}

void print(const ScanInfo& scan) {
  const MeshStatistics& s = scan.statistics;
  const Vec3d size = s.box_max - s.box_min;
  std::printf("%-22s %s\n%-22s %s\n", "name", scan.name.c_str(), "id", scan.id.c_str());
  print_count("file bytes", scan.size_bytes);
  print_count("vertices", s.vertices);
  print_count("triangles", s.triangles);
  print_count("boundary edges", s.boundary_edges);
  print_count("non-manifold edges", s.non_manifold_edges);
  print_count("components", s.components);
  print_count("zero-area triangles", s.zero_area_triangles);
  print_count("unreferenced vertices", s.unreferenced_vertices);
  std::printf("%-22s %.6g x %.6g x %.6g\n", "box", size.x(), size.y(), size.z());
  std::printf("%-22s %.6g\n%-22s %.6g\n", "area", s.area, "mean edge", s.mean_edge_length);
  std::printf("%-22s %d\n", "default depth", scan.default_depth);
  std::printf("%s\n", edges_text(s, scan.unit, scan.default_depth).c_str());
  for (const PreparedInfo& prepared : scan.prepared)
    std::printf("%-22s depth %d, curvature radius %g, %llu bytes\n", "prepared", prepared.key.depth,
                prepared.key.curvature_radius,
                static_cast<unsigned long long>(prepared.size_bytes));
}

void print(const PreparedDescription& prepared) {
  std::printf("at depth %d:\n", prepared.key.depth);
  print_count("  cells", prepared.cells);
  print_count("  memory bytes", prepared.memory_bytes);
  std::printf("%-22s %.6g\n%-22s %.6g\n", "  cell size", prepared.cell_size, "  L = sqrt(area)",
              prepared.length_unit);
  std::printf("%-22s -%g..%g\n", "  curvature range", prepared.histogram_range,
              prepared.histogram_range);
  if (const std::string walls = describe(prepared.walls); !walls.empty())
    std::printf("  %s\n", walls.c_str());
}

Status run(const DescribeOptions& options) {
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  ASSIGN_OR_RETURN(const ScanDescription description,
                   connection.describe_scan(options.scan, options.depth));
  const ScanInfo& scan = description.scan;
  if (options.server.json) {
    print_json(options.depths ? depths_to_json(scan.statistics, scan.default_depth)
                              : to_json(description));
    return Status::ok();
  }
  if (options.depths) {
    print_depths(scan.statistics, scan.default_depth);
    return Status::ok();
  }
  print(scan);
  if (description.prepared) print(*description.prepared);
  return Status::ok();
}

}  // namespace

void add_describe_command(CommandTable& table) {
  auto options = std::make_shared<DescribeOptions>();
  CLI::App* command = table.add("describe", "Show what the server knows about a scan",
                                [options] { return run(*options); });
  command->add_option("SCAN", options->scan, "Name, id, or the beginning of an id")->required();
  command->add_option("--depth", options->depth, "Prepared mesh to describe; left out: deepest")
      ->check(in_range(kDepthMin, kDepthMax));
  command->add_flag("--depths", options->depths,
                    "Tell what each depth would cost: cell size, memory, time to prepare");
  add_server_options(*command, options->server);
}

}  // namespace burnish
