// Measures what opening a prepared scan makes: the hierarchy, and its shards for two devices; and a
// session, when the scan is opened first and again. The session takes two devices if they are
// there.

#include <functional>
#include <unistd.h>

#include "common/base/parallel.h"
#include "common/base/process_memory.h"
#include "server/prepare/prepare.h"
#include "server/session/session.h"
#include "server/solver/cuda/cuda_backend.h"
#include "server/solver/hierarchy/hierarchy.h"
#include "server/solver/kept/hierarchy_file.h"
#include "server/solver/multi/shard.h"
#include "server/solver/tuning/plan_cycle.h"
#include "tests/bench/bench_main.h"
#include "tests/bench/timing.h"

namespace burnish {
namespace {

constexpr int kShards = 2;
constexpr size_t kCellsForOneThreadMax = 20'000'000;  // it takes minutes
constexpr uint64_t kFingerprint = 1;

/// The files of a scan, in a folder that goes with them.
struct ScanFiles {
  ScanFiles() { std::filesystem::create_directories(folder); }
  ~ScanFiles() { std::filesystem::remove_all(folder); }
  ScanFiles(const ScanFiles&) = delete;
  ScanFiles& operator=(const ScanFiles&) = delete;

  std::filesystem::path folder = std::filesystem::temp_directory_path() /
                                 ("burnish-opening-bench-" + std::to_string(getpid()));
  std::filesystem::path prepared = folder / "scan.prepared";
  std::filesystem::path hierarchy = folder / "scan.hierarchy";
};

/// Milliseconds of one opening, and by how much memory grew at most, with mapped files.
struct Opening {
  double prepared = 0;
  double hierarchy = 0;
  double session = 0;
  double peak_bytes = 0;
  Multigrid on;

  double sum() const { return prepared + hierarchy + session; }
};

SolverOptions session_options() {
  const bool has_devices = cuda_device().is_ok() && cuda_memory_by_device().size() >= kShards;
  return {.devices = has_devices ? kShards : 0};
}

std::shared_ptr<const PreparedMesh> hold_or_copy(const ScanFiles& files) {
  auto held = hold_prepared_mesh(files.prepared, files.folder);
  if (held.is_ok()) return std::move(held).value();
  return read_prepared_mesh(files.prepared, ScratchSpace(files.folder, 0)).value();
}

using FindHierarchy = std::function<Multigrid(std::shared_ptr<const PreparedMesh>)>;

// Reads the prepared data as a server does, and ends when the session takes edits.
Opening open_scan(const ScanFiles& files, const FindHierarchy& find) {
  (void)reset_peak_resident_bytes();
  const uint64_t before = resident_bytes();
  Opening opening;
  std::shared_ptr<const PreparedMesh> prepared;
  std::unique_ptr<Session> session;
  opening.prepared = milliseconds([&] { prepared = hold_or_copy(files); });
  opening.hierarchy = milliseconds([&] { opening.on = find(prepared); });
  opening.session =
      milliseconds([&] { session = Session::open(opening.on, session_options()).value(); });
  opening.peak_bytes = static_cast<double>(peak_resident_bytes() - before);
  return opening;
}

Status measure_again(const std::string& name, const ScanFiles& files, int threads,
                     BenchTable& table) {
  Opening first =
      open_scan(files, [](auto prepared) { return make_multigrid(std::move(prepared)).value(); });
  Status written;
  const double writing =
      milliseconds([&] { written = write_hierarchy(first.on, kFingerprint, files.hierarchy); });
  RETURN_IF_ERROR(written);
  first.on = {};
  const Opening again = open_scan(files, [&](auto prepared) {
    return read_hierarchy(files.hierarchy, std::move(prepared), kFingerprint).value();
  });
  const auto bytes = static_cast<double>(std::filesystem::file_size(files.hierarchy));
  table.add({name, static_cast<double>(threads), first.prepared * 1e-3, first.hierarchy * 1e-3,
             first.session * 1e-3, first.sum() * 1e-3, again.prepared * 1e-3,
             again.hierarchy * 1e-3, again.session * 1e-3, again.sum() * 1e-3,
             again.sum() / first.sum(), bytes * 1e-6, writing * 1e-3, first.peak_bytes * 1e-6,
             again.peak_bytes * 1e-6});
  return Status::ok();
}

struct Tables {
  BenchTable& opening;
  BenchTable& again;
};

Status report_scan(const ScanArgument& scan, const BenchArguments& arguments, BenchReport& report,
                   Tables& tables) {
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
  const ScanFiles files;
  RETURN_IF_ERROR(write_prepared_mesh(*made.prepared, files.prepared));
  for (const int threads : thread_counts(arguments)) {
    if (threads == 1 && made.prepared->cells.size() > kCellsForOneThreadMax) continue;
    use_threads(threads);
    const double hierarchy = milliseconds([&] { made.hierarchy = make_hierarchy(*made.prepared); });
    const double cut = milliseconds([&] { (void)make_shards(made, kShards); });
    tables.opening.add({name, static_cast<double>(made.hierarchy->at(depth).grid.corner_count()),
                        static_cast<double>(threads), hierarchy * 1e-3, cut * 1e-3});
    made.hierarchy = nullptr;
    RETURN_IF_ERROR(measure_again(name, files, threads, tables.again));
  }
  return Status::ok();
}

Status run(const BenchArguments& arguments, BenchReport& report) {
  Tables tables{report.add_table("opening", {{"scan", "", 18},
                                             {"corners", "%.0f"},
                                             {"threads", "%.0f"},
                                             {"hierarchy_s", "%.2f"},
                                             {"two_shards_s", "%.2f"}}),
                report.add_table("again", {{"scan", "", 18},
                                           {"threads", "%.0f"},
                                           {"prepared_s", "%.2f"},
                                           {"hierarchy_s", "%.2f"},
                                           {"session_s", "%.2f"},
                                           {"editing_after_s", "%.2f"},
                                           {"again_prepared_s", "%.2f"},
                                           {"again_hierarchy_s", "%.2f"},
                                           {"again_session_s", "%.2f"},
                                           {"again_editing_after_s", "%.2f"},
                                           {"part", "%.2f"},
                                           {"file_mb", "%.0f"},
                                           {"writing_s", "%.2f"},
                                           {"peak_mb", "%.0f"},
                                           {"again_peak_mb", "%.0f"}})};
  for (const ScanArgument& scan : arguments.scans)
    RETURN_IF_ERROR(report_scan(scan, arguments, report, tables));
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::bench_main({"opening_bench", {"blob:1000000@9", "sheets:500000@9"}, burnish::run},
                             argc, argv);
}
