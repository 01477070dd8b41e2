#include "tests/bench/peers/comparison.h"

#include <algorithm>
#include <cstdio>

#include "server/solver/cuda/cuda_backend.h"
#include "tests/bench/peers/measure_ours.h"
#include "tests/bench/peers/measure_peer.h"
#include "tests/bench/peers/report.h"
#include "tests/bench/peers/threads.h"
#include "tests/bench/timing.h"

namespace burnish::bench {

using nlohmann::ordered_json;

namespace {

/// One scan. Answers are the same for any number of threads, so each is found once.
class Comparison {
 public:
  Comparison(const TriangleMesh& mesh, int depth, const ComparisonOptions& options)
      : mesh_(mesh), depth_(depth), options_(options) {}

  Result<ordered_json> run() {
    ordered_json out = ordered_json::array();
    for (const int threads : options_.threads) {
      use_threads_everywhere(threads);
      std::printf("\n  BLAS: %s\n", blas_in_words().c_str());
      by_alpha_.clear();
      ASSIGN_OR_RETURN(const PreparedScan scan, prepare_scan(mesh_, depth_));
      diagonal_ = scan.prepared->statistics.diagonal();
      print_preparation(scan);
      std::vector<Row> on_grid = measure_on_grid(scan);
      ASSIGN_OR_RETURN(auto ours, measure(scan, BackendKind::kCpu));
      add("burnish", threads, std::move(ours));
      if (cuda_device().is_ok()) {
        ASSIGN_OR_RETURN(auto on_cuda, measure(scan, BackendKind::kCuda));
        add("burnish on CUDA", threads, std::move(on_cuda));
      }
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
  Result<std::vector<Row>> measure(const PreparedScan& scan, BackendKind backend) const {
    return measure_ours(scan, backend, options_.alphas, grid_answers_);
  }

  bool wants(std::string_view peer) const {
    const auto& peers = options_.peers;
    return peers.empty() || std::find(peers.begin(), peers.end(), peer) != peers.end();
  }

  void print_preparation(const PreparedScan& scan) const {
    std::printf("  prepare:");
    for (const auto& phase : scan.report.phases)
      std::printf(" %s %.2f s", phase.name.c_str(), phase.seconds);
    std::printf("\n");
  }

  PeerTask task(const LinearSystem& system, double assembly_ms) const {
    return {&system, assembly_ms, diagonal_, options_.bytes_max};
  }

  std::vector<Row> measure_on_grid(const PreparedScan& scan) {
    const PeerKind& cholmod = peer_kinds().front();
    if (!wants(kGridPeer)) return {};
    std::unique_ptr<LinearSystem> system;
    const double ms =
        milliseconds([&] { system = make_grid_system(*scan.prepared, *scan.hierarchy); });
    auto rows = measure_peer(cholmod, task(*system, ms), options_.alphas, grid_answers_);
    for (Row& row : rows) row.note += "; its setup leaves out our preparation, which it needs too";
    return rows;
  }

  void measure_on_mesh(int threads) {
    std::unique_ptr<LinearSystem> system;
    const double ms = milliseconds([&] { system = make_cotangent_system(mesh_); });
    for (const PeerKind& kind : peer_kinds())
      if (wants(kind.name))
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

  const TriangleMesh& mesh_;
  int depth_;
  const ComparisonOptions& options_;
  double diagonal_ = 1;
  Answers grid_answers_, mesh_answers_;
  std::map<double, std::vector<Row>> by_alpha_;
};

}  // namespace

Result<ordered_json> compare(const TriangleMesh& mesh, int depth,
                             const ComparisonOptions& options) {
  return Comparison(mesh, depth, options).run();
}

}  // namespace burnish::bench
