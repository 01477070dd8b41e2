#include "client/cli/filter/filter_report.h"

#include <string>

#include <nlohmann/json.hpp>

#include "common/base/atomic_file.h"
#include "common/base/parallel.h"

namespace burnish {

using nlohmann::ordered_json;

static ordered_json to_json(const Vec3d& v) {
  return {v.x(), v.y(), v.z()};
}

static ordered_json grid_of(const PreparedMesh& prepared) {
  return {{"origin", to_json(prepared.frame.origin)},
          {"cell_size", prepared.frame.cell_size},
          {"L", prepared.length_unit},
          {"depth", prepared.frame.depth}};
}

static ordered_json counts_of(const PreparedMesh& prepared, int32_t corners) {
  const MeshStatistics& statistics = prepared.statistics;
  return {{"vertices", statistics.vertices},
          {"triangles", statistics.triangles},
          {"boundary_edges", statistics.boundary_edges},
          {"non_manifold_edges", statistics.non_manifold_edges},
          {"components", statistics.components},
          {"zero_area_triangles", statistics.zero_area_triangles},
          {"unreferenced_vertices", statistics.unreferenced_vertices},
          {"area", statistics.area},
          {"diagonal", statistics.diagonal()},
          {"cells", prepared.cells.size()},
          {"corners", corners}};
}

static ordered_json phases_of(const FilterRun& run) {
  ordered_json phases = ordered_json::array();
  const auto add = [&](const std::string& name, double seconds) -> ordered_json& {
    phases.push_back({{"name", name}, {"seconds", seconds}});
    return phases.back();
  };
  add("read", run.read_seconds);
  for (const PrepareReport::Phase& phase : run.prepare.phases)
    add(phase.name, phase.seconds)["peak_bytes"] = phase.peak_bytes;
  add("hierarchy", run.hierarchy_seconds);
  add("assemble", run.solve.assemble_seconds);
  add("solve", run.solve.solve_seconds);
  add("write", run.write_seconds);
  return phases;
}

static ordered_json memory_of(const Session& session, const FilterRun& run) {
  const double cells = static_cast<double>(session.prepared().cells.size());
  const uint64_t session_bytes = session.solver().byte_count();
  return {{"prepared_bytes", session.prepared().byte_count()},
          {"hierarchy_bytes", run.hierarchy_bytes},
          {"session_bytes", session_bytes},
          {"integral_bytes_per_cell", session.prepared().integrals.size_bytes() / cells},
          {"hierarchy_bytes_per_corner", static_cast<double>(run.hierarchy_bytes) / run.corners},
          {"session_bytes_per_corner", static_cast<double>(session_bytes) / run.corners}};
}

static ordered_json rims_of(const Session& session) {
  const auto rims = session.edited().pinned_rims();
  if (!rims || rims->rims == 0) return nullptr;
  return {{"number", rims->rims}, {"held", rims->held}};
}

static ordered_json walls_of(const ThinWalls& walls) {
  if (walls.share <= 0) return nullptr;
  return {{"share", walls.share},
          {"depth", walls.depth > 0 ? ordered_json(walls.depth) : ordered_json()}};
}

static ordered_json edges_of(const Session& session, const FilterRun& run) {
  const EdgeFilter& edges = session.fields().settings().edges;
  ordered_json report = nullptr;
  if (edges.is_on())
    report = {{"filter", std::string(name_of(edges.kind))},
              {"strength", edges.strength},
              {"angle", edges.edge_angle},
              {"passes", edges.passes},
              {"crispness", edges.crispness}};
  if (run.proposal) {
    report["noise"] = run.proposal->noise;
    report["noise_in_edges"] = run.proposal->noise_in_edges();
  }
  return report;
}

Status write_filter_report(const Session& session, const FilterRun& run,
                           const std::filesystem::path& path) {
  const ordered_json report = {{"grid", grid_of(session.prepared())},
                               {"counts", counts_of(session.prepared(), run.corners)},
                               {"backend", std::string(session.solver().backend_name())},
                               {"rims", rims_of(session)},
                               {"walls", walls_of(session.prepared().walls)},
                               {"backend_reason", session.solver().backend_reason()},
                               {"edges", edges_of(session, run)},
                               {"threads", thread_count()},
                               {"phases", phases_of(run)},
                               {"memory", memory_of(session, run)},
                               {"cycles", run.solve.cycles},
                               {"converged", run.solve.converged},
                               {"fell_back", run.solve.last.fell_back},
                               {"energy", run.solve.last.energy},
                               {"residual", run.solve.last.residual},
                               {"distance", run.solve.last.distance},
                               {"volume", run.volume ? ordered_json(*run.volume) : ordered_json()}};
  return write_file(path, report.dump(2) + "\n");
}

}  // namespace burnish
