// Measures what opening a prepared scan makes: the hierarchy, and its shards for two devices.

#include "common/base/parallel.h"
#include "server/prepare/prepare.h"
#include "server/solver/hierarchy/hierarchy.h"
#include "server/solver/multi/shard.h"
#include "tests/bench/bench_main.h"
#include "tests/bench/timing.h"

namespace burnish {
namespace {

constexpr int kShards = 2;

Status report_scan(const ScanArgument& scan, const BenchArguments& arguments, BenchReport& report,
                   BenchTable& table) {
  ASSIGN_OR_RETURN(const TriangleMesh mesh, load_mesh(scan));
  const int depth = depth_of(scan, mesh);
  const std::string name = scan.name() + "@" + std::to_string(depth);
  const Status fits = check_size(name, mesh, depth, arguments.corners_max);
  if (!fits.is_ok()) {
    report.remark("left out: " + fits.message());
    return Status::ok();
  }
  Multigrid made;
  ASSIGN_OR_RETURN(made.prepared, prepare(mesh, {.depth = depth}));
  made.plan = std::make_shared<CyclePlan>();
  for (const int threads : thread_counts(arguments)) {
    use_threads(threads);
    made.hierarchy = nullptr;
    const double hierarchy = milliseconds([&] { made.hierarchy = make_hierarchy(*made.prepared); });
    Shards shards;
    const double cut = milliseconds([&] { shards = make_shards(made, kShards); });
    table.add({name, static_cast<double>(made.hierarchy->at(depth).grid.corner_count()),
               static_cast<double>(threads), hierarchy * 1e-3, cut * 1e-3});
  }
  return Status::ok();
}

Status run(const BenchArguments& arguments, BenchReport& report) {
  BenchTable& table = report.add_table("opening", {{"scan", "", 18},
                                                   {"corners", "%.0f"},
                                                   {"threads", "%.0f"},
                                                   {"hierarchy_s", "%.2f"},
                                                   {"two_shards_s", "%.2f"}});
  for (const ScanArgument& scan : arguments.scans)
    RETURN_IF_ERROR(report_scan(scan, arguments, report, table));
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::bench_main({"opening_bench", {"blob:1000000@9", "sheets:500000@9"}, burnish::run},
                             argc, argv);
}
