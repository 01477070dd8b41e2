// The product beside other solvers, on the same scan in one run: direct and iterative ones on the
// cotangent system of the scan's own vertices, and CHOLMOD on the product's own matrix as well.
//
//     peers_bench [--json FILE] [--threads N,...] [--alpha A,...] [--peers NAME,...]
//                 [--mebibytes N] [--vertices N] [SCAN DEPTH]...
//
// SCAN is a mesh file or the kind of a generated scan; without any: blob 8 tablet 8.

#include <cstdio>
#include <fstream>

#include <CLI/CLI.hpp>

#include "common/base/parallel.h"
#include "common/base/process_memory.h"
#include "common/mesh/generate.h"
#include "common/mesh/mesh_io.h"
#include "tests/bench/peers/measure_ours.h"
#include "tests/bench/peers/measure_peer.h"
#include "tests/bench/peers/report.h"
#include "tests/bench/peers/stopwatch.h"
#include "tests/bench/peers/threads.h"

namespace burnish::bench {
namespace {

using nlohmann::ordered_json;

constexpr std::string_view kGridPeer = "CHOLMOD on our matrix";

std::vector<int> one_and_all() {
  return thread_count() > 1 ? std::vector<int>{1, thread_count()} : std::vector<int>{1};
}

struct Options {
  std::string json_file;
  std::vector<int> threads = one_and_all();
  std::vector<double> alphas = {50, 5};
  std::vector<std::string> peers;  ///< empty: all
  uint64_t mebibytes = available_memory_bytes() >> 21;
  uint64_t vertices = 200'000;
  std::vector<std::string> scans = {"blob", "8", "tablet", "8"};

  bool wants(std::string_view peer) const {
    return peers.empty() || std::find(peers.begin(), peers.end(), peer) != peers.end();
  }
};

TriangleMesh load(const std::string& scan, uint64_t vertices) {
  for (const GeneratedScanKind& kind : generated_scan_kinds())
    if (kind.name == scan) return generate_scan({.kind = scan, .vertices = vertices}).value();
  return read_mesh(scan).value();
}

/// One scan; answers are the same for any number of threads and found once.
class ScanBench {
 public:
  ScanBench(TriangleMesh mesh, int depth, const Options& options)
      : mesh_(std::move(mesh)), depth_(depth), options_(options) {}

  ordered_json run() {
    ordered_json out = ordered_json::array();
    for (const int threads : options_.threads) {
      use_threads_everywhere(threads);
      std::printf("\n  BLAS: %s\n", blas_in_words().c_str());
      by_alpha_.clear();
      const PreparedScan scan = prepare_scan(mesh_, depth_).value();
      diagonal_ = scan.prepared->statistics.diagonal();
      print_preparation(scan);
      std::vector<Row> on_grid = measure_on_grid(scan);
      add("burnish", threads, measure_ours(scan, options_.alphas, grid_answers_).value());
      measure_on_mesh(threads);
      add(kGridPeer, threads, std::move(on_grid));
      for (const double alpha : options_.alphas) {
        print_rows(by_alpha_[alpha]);
        print_discretisation(alpha);
        for (auto& row : rows_to_json(by_alpha_[alpha])) out.push_back(row);
      }
    }
    return out;
  }

 private:
  void print_preparation(const PreparedScan& scan) const {
    std::printf("  prepare:");
    for (const auto& phase : scan.report.phases)
      std::printf(" %s %.2f s", phase.name.c_str(), phase.seconds);
    std::printf("\n");
  }

  PeerTask task(const LinearSystem& system, double assembly_ms) const {
    return {&system, assembly_ms, diagonal_, options_.mebibytes << 20};
  }

  std::vector<Row> measure_on_grid(const PreparedScan& scan) {
    const PeerKind& cholmod = peer_kinds().front();
    if (!options_.wants(kGridPeer)) return {};
    std::unique_ptr<LinearSystem> system;
    const double ms =
        milliseconds([&] { system = make_grid_system(*scan.prepared, *scan.hierarchy); });
    return measure_peer(cholmod, task(*system, ms), options_.alphas, grid_answers_);
  }

  void measure_on_mesh(int threads) {
    std::unique_ptr<LinearSystem> system;
    const double ms = milliseconds([&] { system = make_cotangent_system(mesh_); });
    for (const PeerKind& kind : peer_kinds())
      if (options_.wants(kind.name))
        add(kind.name, threads,
            measure_peer(kind, task(*system, ms), options_.alphas, mesh_answers_));
  }

  /// A peer that failed at once has one row, which stands for every α.
  void add(std::string_view name, int threads, std::vector<Row> rows) {
    for (size_t i = 0; i < options_.alphas.size() && !rows.empty(); ++i) {
      Row row = rows[std::min(i, rows.size() - 1)];
      row.name = name;
      row.threads = threads;
      row.alpha = options_.alphas[i];
      by_alpha_[row.alpha].push_back(std::move(row));
    }
  }

  void print_discretisation(double alpha) const {
    if (!mesh_answers_.contains(alpha) || !grid_answers_.contains(alpha)) return;
    const Distance d =
        distance_between(mesh_answers_.at(alpha), grid_answers_.at(alpha), diagonal_);
    std::printf("  the grid's answer is %.1e (max), %.1e (rms) from the cotangent one\n", d.max,
                d.rms);
  }

  TriangleMesh mesh_;
  int depth_;
  const Options& options_;
  double diagonal_ = 1;
  Answers grid_answers_, mesh_answers_;
  std::map<double, std::vector<Row>> by_alpha_;
};

void run(const Options& options) {
  ordered_json report = ordered_json::array();
  for (size_t i = 0; i + 1 < options.scans.size(); i += 2) {
    TriangleMesh mesh = load(options.scans[i], options.vertices);
    std::printf("\n%s, depth %s: %zu vertices, %zu triangles\n", options.scans[i].c_str(),
                options.scans[i + 1].c_str(), mesh.vertices.size(), mesh.triangles.size());
    const size_t vertices = mesh.vertices.size();
    const int depth = std::stoi(options.scans[i + 1]);
    report.push_back({{"scan", options.scans[i]},
                      {"depth", depth},
                      {"vertices", vertices},
                      {"rows", ScanBench(std::move(mesh), depth, options).run()}});
  }
  if (!options.json_file.empty()) std::ofstream(options.json_file) << report.dump(2) << "\n";
}

}  // namespace

int main_of(int argc, char** argv) {
  Options options;
  CLI::App app("Burnish beside CHOLMOD, Eigen and hypre on the same scans");
  app.add_option("--json", options.json_file, "Write the figures to this file");
  const auto add_list = [&app](const char* name, auto& list, const char* help) {
    app.add_option(name, list, help)->delimiter(',')->allow_extra_args(false);
  };
  add_list("--threads", options.threads, "Numbers of threads, one table each");
  add_list("--alpha", options.alphas, "Fidelity weights");
  add_list("--peers", options.peers, "Only these, by the table's names");
  app.add_option("--mebibytes", options.mebibytes, "A larger factor is not tried");
  app.add_option("--vertices", options.vertices, "Of generated scans");
  app.add_option("scans", options.scans, "SCAN DEPTH pairs");
  CLI11_PARSE(app, argc, argv);
  run(options);
  return 0;
}

}  // namespace burnish::bench

int main(int argc, char** argv) {
  return burnish::bench::main_of(argc, argv);
}
