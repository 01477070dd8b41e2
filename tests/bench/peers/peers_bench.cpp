// Measures the product next to other solvers, on the same scan in one run: direct and iterative
// ones on the cotangent system of the scan's own vertices, and CHOLMOD on the product's own matrix.
//
//     peers_bench [--json FILE] [--threads N,...] [--alpha A,...] [--peers NAME,...]
//                 [--mebibytes N] [SCAN[@DEPTH]]...
//
// SCAN is a mesh file, or KIND:VERTICES of a generated scan.

#include <cstdio>
#include <fstream>
#include <iostream>

#include <CLI/CLI.hpp>

#include "common/base/limits.h"
#include "common/base/parallel.h"
#include "common/base/process_memory.h"
#include "tests/bench/input.h"
#include "tests/bench/peers/comparison.h"
#include "tests/bench/peers/peer.h"

namespace burnish::bench {
namespace {

using nlohmann::ordered_json;

struct Options {
  ComparisonOptions comparison{.threads = {1}, .alphas = {50, 5}};
  std::string json_file;
  uint64_t mebibytes_max = available_memory_bytes() >> 21;
  std::vector<std::string> scans = {"blob:100000@7", "tablet:100000@7"};
};

std::vector<std::string> peer_names() {
  std::vector<std::string> names = {std::string(kGridPeer)};
  for (const PeerKind& kind : peer_kinds()) names.emplace_back(kind.name);
  return names;
}

Status run(const Options& options) {
  ordered_json report = ordered_json::array();
  for (const std::string& text : options.scans) {
    ASSIGN_OR_RETURN(const ScanArgument scan, parse_scan(text));
    ASSIGN_OR_RETURN(const TriangleMesh mesh, load_mesh(scan));
    const int depth = depth_of(scan, mesh);
    std::printf("\n%s, depth %d: %zu vertices, %zu triangles\n", scan.name().c_str(), depth,
                mesh.vertices.size(), mesh.triangles.size());
    ASSIGN_OR_RETURN(ordered_json rows, compare(mesh, depth, options.comparison));
    report.push_back({{"scan", scan.name()},
                      {"depth", depth},
                      {"vertices", mesh.vertices.size()},
                      {"rows", std::move(rows)}});
  }
  if (!options.json_file.empty()) std::ofstream(options.json_file) << report.dump(2) << "\n";
  return Status::ok();
}

}  // namespace

int main_of(int argc, char** argv) {
  Options options;
  ComparisonOptions& comparison = options.comparison;
  if (thread_count() > 1) comparison.threads.push_back(thread_count());
  CLI::App app("Burnish beside CHOLMOD, Eigen and hypre on the same scans");
  app.add_option("--json", options.json_file, "Write the figures to this file");
  const auto add_list = [&app](const char* name, auto& list, const char* help) {
    return app.add_option(name, list, help)->delimiter(',')->allow_extra_args(false);
  };
  add_list("--threads", comparison.threads, "Numbers of threads, one table each");
  add_list("--alpha", comparison.alphas, "Fidelity weights, one table each")
      ->check(CLI::Range(kAlphaMin, kAlphaMax / 2));
  add_list("--peers", comparison.peers, "Only these")->check(CLI::IsMember(peer_names()));
  app.add_option("--mebibytes", options.mebibytes_max, "A larger factor is not tried");
  app.add_option("scans", options.scans, "SCAN[@DEPTH]");
  CLI11_PARSE(app, argc, argv);
  comparison.bytes_max = options.mebibytes_max << 20;
  const Status status = run(options);
  if (status.is_ok()) return 0;
  std::cerr << "peers_bench: " << status.message() << "\n";
  return 1;
}

}  // namespace burnish::bench

int main(int argc, char** argv) {
  return burnish::bench::main_of(argc, argv);
}
