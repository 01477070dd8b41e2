// Measures what a user waits for when a scan opens: its first picture, and the first frame of its
// session; when the scan opens first, and again once its hierarchy is kept.
//
//   waiting_bench [OPTION]... [SCAN[@DEPTH]]...   see bench_main.h
//
// The client does all that a window does, but draws no pictures. The server starts anew for each
// opening, so that nothing of the scan is in its memory.

#include <fstream>
#include <thread>

#include "client/model/workspace/workspace.h"
#include "client/scene/null_page_renderer.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/bench/bench_main.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// A user's client, without a window.
class Client {
 public:
  explicit Client(const std::string& server) {
    workspace_.viewport.set_size({1280, 720});
    workspace_.connect(server);
    wait([this] { return !workspace_.library().scans.empty(); });
  }

  struct Waits {
    double picture_s = 0;  ///< until a surface is on the card
    double triangles = 0;  ///< of it
    double editing_s = 0;  ///< until the session's first frame
  };

  /// `depth`: 0 is the scan's own.
  Result<Waits> open(int depth) {
    Waits waits;
    const Clock::time_point begin = Clock::now();
    workspace_.open_scan(workspace_.library().scans.front(), Opening::kGoOn, depth);
    wait([&] {
      if (waits.picture_s == 0 && has_surface()) {
        waits.picture_s = seconds_since(begin);
        waits.triangles = triangles();
      }
      return !workspace_.is_opening() && (!workspace_.document() || has_frame());
    });
    waits.editing_s = seconds_since(begin);
    if (workspace_.document()) return waits;
    return internal_error("the scan does not open: " + workspace_.log.messages().back().text);
  }

 private:
  bool has_frame() const { return workspace_.document()->stats().frames > 0; }
  bool has_surface() const {
    return workspace_.raw() ||
           (workspace_.document() && !workspace_.document()->surface().patches().empty());
  }
  double triangles() const {
    const RawScan* const raw = workspace_.raw();
    return static_cast<double>(raw ? drawn_triangles(*raw)
                                   : workspace_.document()->surface().status().triangles_drawn);
  }
  template <typename What>
  void wait(What what) {
    for (workspace_.update(); !what(); workspace_.update()) {
      const Status looked = workspace_.look();
      BURNISH_CHECK(looked.is_ok(), looked.message());
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }

  NullPageRenderer renderer_;
  Workspace workspace_{renderer_, Preferences(), {}};
};

/// Returns the most memory that a process has had, with mapped files, MB; 0: unknown.
double peak_mb_of(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1e3;
  return 0;
}

bool has_kept_hierarchy(const std::filesystem::path& data) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(data))
    if (entry.path().extension() == ".hierarchy") return true;
  return false;
}

void start_again(ServerProcess& server) {
  server.process->signal(SIGTERM);
  while (!server.process->wait(kPatience)) {
  }
  server.start();
}

Status measure_opening(ServerProcess& server, const ScanArgument& scan, const char* opening,
                       BenchTable& table) {
  start_again(server);
  Client client(server.address);
  ASSIGN_OR_RETURN(const Client::Waits waits, client.open(scan.depth));
  table.add({scan.name(), opening, waits.picture_s, waits.triangles, waits.editing_s,
             peak_mb_of(server.process->pid())});
  while (!has_kept_hierarchy(server.folder / "data"))
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  return Status::ok();
}

Status measure_scan(const ScanArgument& scan, BenchTable& table) {
  ServerProcess server;
  {
    ASSIGN_OR_RETURN(const TriangleMesh mesh, load_mesh(scan));
    const auto file = server.folder / "scan.ply";
    RETURN_IF_ERROR(write_mesh(mesh, file));
    ASSIGN_OR_RETURN(Connection owner, Connection::open(server.address, kPatience));
    RETURN_IF_ERROR(owner.import_scan(file, "scan", {scan.depth, 0}, {}).status());
  }
  RETURN_IF_ERROR(measure_opening(server, scan, "first", table));
  return measure_opening(server, scan, "again", table);
}

Status run(const BenchArguments& arguments, BenchReport& report) {
  BenchTable& table = report.add_table("waiting", {{"scan", "%s", 24},
                                                   {"opening", "%s", 7},
                                                   {"picture_s", "%.2f"},
                                                   {"picture_triangles", "%.0f"},
                                                   {"editing_s", "%.2f"},
                                                   {"server_peak_mb", "%.0f"}});
  for (const ScanArgument& scan : arguments.scans) RETURN_IF_ERROR(measure_scan(scan, table));
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::bench_main({"waiting_bench", {"blob:1100000"}, burnish::run}, argc, argv);
}
