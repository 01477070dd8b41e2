// Measures how soon a window shows what it looks at, and what that costs, over simulated links to a
// real server.
//
//   view_bench [OPTION]... [SCAN[@DEPTH]]...   see bench_main.h
//
// The client does all that a window does, but draws no pictures: how long they take is
// draw_bench's. The times of the first picture and of the whole view begin with the answer of
// OpenSession. BURNISH_FLIGHT_MINUTES=10 flies over each scan for so long, and measures the
// client's memory.

#include <cstdlib>

#include "client/connection/connection.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/bench/bench_main.h"
#include "tests/bench/view_case.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

constexpr double kMegabitsPerSecond[] = {50, 10};

struct ViewTables {
  BenchTable& views;
  BenchTable& motion;
  BenchTable& flights;
};

ViewTables add_tables(BenchReport& report) {
  return {report.add_table("views", {{"scan", "%s", 24},
                                     {"mbit_per_s", "%.0f"},
                                     {"describe_ms", "%.0f"},
                                     {"describe_kb", "%.0f"},
                                     {"unsolved_ms", "%.0f"},
                                     {"first_ms", "%.0f"},
                                     {"whole_ms", "%.0f"},
                                     {"whole_kb", "%.0f"},
                                     {"whole_triangles", "%.0f"},
                                     {"zoom_ms", "%.0f"},
                                     {"zoom_kb", "%.0f"},
                                     {"full_ms", "%.0f"},
                                     {"full_kb", "%.0f"},
                                     {"full_triangles", "%.0f"}}),
          report.add_table("motion", {{"scan", "%s", 24},
                                      {"mbit_per_s", "%.0f"},
                                      {"still_bytes", "%.0f"},
                                      {"server_ms", "%.0f"},
                                      {"drag_pictures_per_s", "%.1f"},
                                      {"age_p50_ms", "%.0f"},
                                      {"age_p95_ms", "%.0f"},
                                      {"drag_triangles", "%.0f"},
                                      {"full_after_ms", "%.0f"},
                                      {"dab_ms", "%.0f"},
                                      {"dab_kb", "%.1f"},
                                      {"dab_moved_pages", "%.0f"},
                                      {"shown_pages", "%.0f"}}),
          report.add_table("flights", {{"scan", "%s", 24},
                                       {"minutes", "%.1f"},
                                       {"begin_mb", "%.0f"},
                                       {"middle_mb", "%.0f"},
                                       {"end_mb", "%.0f"},
                                       {"most_mb", "%.0f"},
                                       {"fetched_mb", "%.0f"}})};
}

void add_rows(const std::string& scan, const ViewCase& what, const ViewFigures& figures,
              ViewTables& tables) {
  const ViewArrival &described = figures.described, &first = figures.first, &whole = figures.whole;
  tables.views.add({scan, what.megabits_per_second, described.ms, described.bytes / 1e3,
                    figures.unsolved_ms, described.ms + first.ms,
                    described.ms + first.ms + whole.ms,
                    (described.bytes + first.bytes + whole.bytes) / 1e3, whole.triangles,
                    figures.zoomed.ms, figures.zoomed.bytes / 1e3, figures.full.ms,
                    figures.full.bytes / 1e3, figures.full.triangles});
  const DragFigures& drag = figures.drag;
  const DabFigures& dab = figures.dab;
  tables.motion.add({scan, what.megabits_per_second, figures.still_bytes, drag.server_ms,
                     drag.pictures_per_second, drag.age_p50_ms, drag.age_p95_ms, drag.triangles,
                     drag.full_after_ms, dab.ms, dab.bytes / 1e3, dab.moved_pages,
                     dab.shown_pages});
  const FlightFigures& flight = figures.flight;
  if (what.flight_minutes > 0)
    tables.flights.add({scan, what.flight_minutes, flight.begin_mb, flight.middle_mb, flight.end_mb,
                        flight.most_mb, flight.fetched_mb});
}

Status measure_scan(const ScanArgument& scan, double flight_minutes, ViewTables& tables) {
  ServerProcess server;
  ASSIGN_OR_RETURN(const TriangleMesh mesh, load_mesh(scan));
  const auto file = server.folder / "scan.ply";
  RETURN_IF_ERROR(write_mesh(mesh, file));
  ASSIGN_OR_RETURN(Connection owner, Connection::open(server.address, kPatience));
  const PreparedKey key{scan.depth, 0};
  RETURN_IF_ERROR(owner.import_scan(file, "scan", key, {}).status());
  RETURN_IF_ERROR(owner.describe_pages("scan", {}).status());
  for (const double speed : kMegabitsPerSecond) {
    const bool is_first = speed == kMegabitsPerSecond[0];
    const ViewCase what{.server = server.address,
                        .wish = {"scan", "at" + std::to_string(static_cast<int>(speed)), key},
                        .megabits_per_second = speed,
                        .flight_minutes = is_first ? flight_minutes : 0};
    ASSIGN_OR_RETURN(const ViewFigures figures, run_view_case(what));
    add_rows(scan.name(), what, figures, tables);
  }
  return Status::ok();
}

Status run(const BenchArguments& arguments, BenchReport& report) {
  ViewTables tables = add_tables(report);
  const char* minutes = std::getenv("BURNISH_FLIGHT_MINUTES");
  for (const ScanArgument& scan : arguments.scans)
    RETURN_IF_ERROR(measure_scan(scan, minutes ? std::atof(minutes) : 0, tables));
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::bench_main({"view_bench", {"tablet:250000", "tablet:4000000"}, burnish::run},
                             argc, argv);
}
