// Measures what preparing takes by pass: seconds, and the peak of anonymous memory, which mapped
// files are no part of. Once with all arrays in memory, and once with most of them in files.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

#include "common/base/process_memory.h"
#include "common/mesh/stored_mesh.h"
#include "server/prepare/pages/build_pages.h"
#include "server/prepare/prepare.h"
#include "tests/bench/bench_main.h"

namespace burnish {
namespace {

constexpr uint64_t kLittleMemory = uint64_t{256} << 20;

/// A folder that goes with this object.
struct ScratchFolder {
  std::filesystem::path path = std::filesystem::temp_directory_path() /
                               ("burnish-preparation-bench-" + std::to_string(getpid()));

  ScratchFolder() { std::filesystem::create_directories(path); }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

/// Follows the passes of some work, and looks at the memory every few milliseconds.
class PassWatch {
 public:
  explicit PassWatch(std::string first) : passes_{{std::move(first)}} {
    watcher_ = std::thread([this] {
      while (!stop_) {
        look();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      }
    });
  }
  ~PassWatch() {
    stop_ = true;
    watcher_.join();
  }

  Progress progress() {
    return [this](std::string_view pass, double) {
      begin(std::string(pass));
      return true;
    };
  }

  void begin(const std::string& pass) {
    const std::lock_guard lock(mutex_);
    const auto now = std::chrono::steady_clock::now();
    passes_.back().seconds += std::chrono::duration<double>(now - start_).count();
    start_ = now;
    if (pass != passes_.back().name) passes_.push_back({pass});
  }

  struct Pass {
    std::string name;
    double seconds = 0;
    uint64_t bytes = 0;  ///< of anonymous memory, at the peak
  };
  std::vector<Pass> passes() {
    const std::lock_guard lock(mutex_);
    return passes_;
  }

 private:
  void look() {
    const uint64_t bytes = anonymous_bytes();
    const std::lock_guard lock(mutex_);
    passes_.back().bytes = std::max(passes_.back().bytes, bytes);
  }

  std::mutex mutex_;
  std::vector<Pass> passes_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::atomic<bool> stop_ = false;
  std::thread watcher_;
};

Status prepare_watched(const ScanArgument& scan, uint64_t memory_bytes_max, BenchTable& table) {
  const ScratchFolder folder;
  const ScratchSpace space(folder.path, memory_bytes_max);
  auto mesh = std::make_shared<StoredMesh>();
  {
    ASSIGN_OR_RETURN(const TriangleMesh read, load_mesh(scan));
    *mesh = StoredMesh(read, space);
  }
  PassWatch watch("statistics");
  PrepareOptions options;
  options.depth = scan.depth;
  options.space = space;
  ASSIGN_OR_RETURN(auto prepared, prepare(mesh->view(), mesh, options, watch.progress()));
  watch.begin("storing");
  RETURN_IF_ERROR(write_prepared_mesh(*prepared, folder.path / "scan.prepared"));
  const MeshStatistics statistics = prepared->statistics;
  prepared.reset();
  watch.begin("places");
  RETURN_IF_ERROR(build_pages({mesh->vertices, mesh->triangles, mesh->colours, statistics},
                              folder.path / "scan.pages", {.space = space}, watch.progress()));
  watch.begin("end");
  for (const PassWatch::Pass& pass : watch.passes())
    if (pass.name != "end")
      table.add({scan.name(), static_cast<double>(memory_bytes_max >> 20), pass.name, pass.seconds,
                 static_cast<double>(pass.bytes >> 20)});
  return Status::ok();
}

Status run(const BenchArguments& arguments, BenchReport& report) {
  BenchTable& table = report.add_table("preparation_passes", {{"scan", "", 18},
                                                              {"arrays_mib_max", "%.0f"},
                                                              {"pass", "", 12},
                                                              {"seconds", "%.3f"},
                                                              {"anonymous_mib", "%.0f"}});
  for (const ScanArgument& scan : arguments.scans)
    for (const uint64_t memory_bytes_max : {machine_memory_bytes(), kLittleMemory})
      RETURN_IF_ERROR(prepare_watched(scan, memory_bytes_max, table));
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::bench_main(
      {"preparation_bench", {"tablet:1000000", "blob:1000000"}, burnish::run}, argc, argv);
}
