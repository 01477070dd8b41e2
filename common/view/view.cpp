#include "common/view/view.h"

#include "common/view/view_format.h"

namespace burnish {

namespace {

void add_vertex(const ViewSource& scan, size_t vertex, ViewParts& parts) {
  const EvaluationPoint& point = scan.mesh.evaluation[vertex];
  const Vec3d& position = scan.mesh.vertices[vertex];
  parts.homes.push_back(point.cell);
  parts.locals.push_back(point.local);
  if (point.cell == kNone) parts.strays.push_back({position.x(), position.y(), position.z()});
  if (!scan.colours.empty()) parts.colours.push_back(scan.colours[vertex]);
}

}  // namespace

PackedView make_view(const ViewSource& scan, uint64_t triangles_max) {
  ViewParts parts{.frame = scan.frame,
                  .length_unit = scan.length_unit,
                  .scan_vertices = scan.mesh.vertices.size(),
                  .scan_triangles = scan.mesh.triangles.size()};
  parts.cells.assign(scan.cells.begin(), scan.cells.end());
  if (triangles_max == 0 || triangles_max >= scan.mesh.triangles.size()) {
    parts.triangles.assign(scan.mesh.triangles.begin(), scan.mesh.triangles.end());
    for (size_t vertex = 0; vertex < scan.mesh.vertices.size(); ++vertex)
      add_vertex(scan, vertex, parts);
  } else {
    Proxy proxy = make_proxy(scan.mesh, triangles_max);
    parts.triangles = std::move(proxy.triangles);
    for (const uint32_t vertex : proxy.source) add_vertex(scan, vertex, parts);
  }
  return {pack_view(parts), parts.homes.size(), parts.triangles.size(), parts.scan_vertices,
          parts.scan_triangles};
}

Result<View> read_view(std::span<const uint8_t> bytes, uint64_t memory_bytes_max) {
  ASSIGN_OR_RETURN(ViewParts parts, unpack_view(bytes, memory_bytes_max));
  RETURN_IF_ERROR(check_view(parts));
  View view{.frame = parts.frame,
            .length_unit = parts.length_unit,
            .triangles = std::move(parts.triangles),
            .colours = std::move(parts.colours),
            .scan_vertices = parts.scan_vertices,
            .scan_triangles = parts.scan_triangles};
  view.grid = make_finest_grid(parts.frame.depth, parts.cells);
  view.vertices.reserve(parts.homes.size());
  view.points.reserve(parts.homes.size());
  auto stray = parts.strays.begin();
  for (size_t v = 0; v < parts.homes.size(); ++v) {
    const EvaluationPoint point{parts.homes[v], parts.locals[v]};
    view.points.push_back(point);
    if (point.cell == kNone) {
      view.vertices.emplace_back(stray->data());
      ++stray;
    } else {
      const Vec3d local(point.local[0], point.local[1], point.local[2]);
      const Vec3d cell = morton_point(parts.cells[point.cell]).cast<double>();
      view.vertices.push_back(view.frame.to_file(cell + local));
    }
  }
  return view;
}

}  // namespace burnish
