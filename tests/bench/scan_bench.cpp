// Preparation by phase, memory, and the three frames of Table 1 (solve, rhs, matrix), beside the
// machine's memory bandwidth.
//
//     scan_bench [--json FILE] [--threads N] [SCAN DEPTH]...
//
// SCAN is a mesh file or the kind of a generated scan of a million vertices; without any:
// blob 9 tablet 9.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>

#include <nlohmann/json.hpp>

#include "common/base/parallel.h"
#include "common/mesh/generate.h"
#include "common/mesh/mesh_io.h"
#include "server/prepare/prepare.h"
#include "server/session/session.h"
#include "server/solver/hierarchy.h"
#include "tests/bench/triad.h"

namespace burnish {
namespace {

using nlohmann::ordered_json;

constexpr uint64_t kGeneratedVertices = 1'000'000;
constexpr int kFrames = 9;

template <typename Work>
double milliseconds(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

template <typename Work>
double median_milliseconds(Work&& work) {
  std::vector<double> times(kFrames);
  for (double& time : times) time = milliseconds(work);
  std::nth_element(times.begin(), times.begin() + kFrames / 2, times.end());
  return times[kFrames / 2];
}

TriangleMesh load(const std::string& scan) {
  for (const GeneratedScanKind& kind : generated_scan_kinds())
    if (kind.name == scan)
      return generate_scan({.kind = scan, .vertices = kGeneratedVertices}).value();
  return read_mesh(scan).value();
}

std::shared_ptr<const PreparedMesh> prepare_and_report(const TriangleMesh& mesh, int depth,
                                                       ordered_json& out) {
  PrepareReport report;
  std::shared_ptr<const PreparedMesh> prepared;
  const double total =
      milliseconds([&] { prepared = prepare(mesh, {.depth = depth}, {}, &report).value(); });
  uint64_t peak = 0;
  std::printf("  prepare %.2f s:", total * 1e-3);
  for (const auto& phase : report.phases) {
    std::printf(" %s %.2f s (%lu MiB)", phase.name.c_str(), phase.seconds,
                static_cast<unsigned long>(phase.peak_bytes >> 20));
    out["phases"].push_back(
        {{"name", phase.name}, {"seconds", phase.seconds}, {"peak_bytes", phase.peak_bytes}});
    peak = std::max(peak, phase.peak_bytes);
  }
  std::printf("; peak %lu MiB\n", static_cast<unsigned long>(peak >> 20));
  out["prepare_seconds"] = total * 1e-3;
  out["prepare_peak_bytes"] = peak;
  return prepared;
}

void report_frames(Session& session, const std::string& name, const TransferCurve& curve,
                   ordered_json& out) {
  int edit = 0;
  const auto apply = [&](auto change) {
    const Status status = session.apply({std::to_string(edit++), std::move(change)});
    BURNISH_CHECK(status.is_ok(), status.message());
  };
  apply(SetTransferCurve{curve});
  apply(SetGradientScale{0});
  session.step();
  const double solve = median_milliseconds([&] { session.step(); });
  double beta = 0;
  const double rhs = median_milliseconds([&] {
    apply(SetGradientScale{beta += 0.01});
    session.step();
  });
  const double matrix = median_milliseconds([&] {
    apply(SetTransferCurve{curve});
    session.step();
  });
  apply(SetGradientScale{0});
  SolveReport settled;
  const double settle = milliseconds([&] { settled = session.solve({}).value(); });
  const double evaluate = median_milliseconds([&] { session.surface(); });
  std::printf(
      "  %-14s solve %7.1f  rhs %7.1f  matrix %7.1f  evaluate %6.1f ms; a slider step "
      "settles in %d cycles, %.0f ms\n",
      name.c_str(), solve, rhs, matrix, evaluate, settled.cycles, settle);
  out["frames"].push_back({{"curve", name},
                           {"solve_ms", solve},
                           {"rhs_ms", rhs},
                           {"matrix_ms", matrix},
                           {"evaluate_ms", evaluate},
                           {"settle_cycles", settled.cycles},
                           {"settle_ms", settle}});
}

ordered_json run(const std::string& scan, int depth) {
  const TriangleMesh mesh = load(scan);
  ordered_json out = {{"scan", scan}, {"depth", depth}, {"vertices", mesh.vertices.size()}};
  std::printf("%s, depth %d: %zu vertices, %zu triangles\n", scan.c_str(), depth,
              mesh.vertices.size(), mesh.triangles.size());
  const auto prepared = prepare_and_report(mesh, depth, out);
  std::shared_ptr<const Hierarchy> hierarchy;
  const double connect = milliseconds([&] { hierarchy = make_hierarchy(*prepared); });
  const int32_t corners = hierarchy->at(hierarchy->finest).grid.corner_count();
  const auto session = Session::open(prepared, hierarchy, {}).value();
  report_frames(*session, "alpha 5", TransferCurve(5), out);
  report_frames(*session, "alpha 50", TransferCurve(50), out);
  report_frames(*session, "contrast 100", TransferCurve::parse("-20:5,20:500").value(), out);

  const double cells = static_cast<double>(prepared->cells.size());
  const double session_bytes = static_cast<double>(session->solver().byte_count());
  std::printf(
      "  %d corners, %.0f cells; hierarchy %.2f s; bytes: %.0f per cell of integrals, "
      "%.0f per corner of hierarchy, %.0f per corner of session\n",
      corners, cells, connect * 1e-3, prepared->integrals.size_bytes() / cells,
      static_cast<double>(hierarchy->byte_count()) / corners, session_bytes / corners);
  out["corners"] = corners;
  out["cells"] = cells;
  out["hierarchy_seconds"] = connect * 1e-3;
  out["session_bytes_per_corner"] = session_bytes / corners;
  return out;
}

int main_of(const std::vector<std::string>& arguments) {
  std::vector<std::string> scans;
  std::string json_file;
  for (size_t i = 0; i < arguments.size(); ++i) {
    const bool has_next = i + 1 < arguments.size();
    if (arguments[i] == "--json" && has_next)
      json_file = arguments[++i];
    else if (arguments[i] == "--threads" && has_next)
      use_threads(std::atoi(arguments[++i].c_str()));
    else
      scans.push_back(arguments[i]);
  }
  if (scans.empty()) scans = {"blob", "9", "tablet", "9"};
  if (scans.size() % 2 != 0) {
    std::cerr << "usage: scan_bench [--json FILE] [--threads N] [SCAN DEPTH]...\n";
    return 2;
  }
  const double triad = triad_gigabytes_per_second();
  std::printf("%d threads, triad %.1f GB/s\n", thread_count(), triad);
  ordered_json report = {{"threads", thread_count()}, {"triad_gb_per_s", triad}};
  for (size_t i = 0; i < scans.size(); i += 2)
    report["scans"].push_back(run(scans[i], std::atoi(scans[i + 1].c_str())));
  if (!json_file.empty()) std::ofstream(json_file) << report.dump(2) << "\n";
  return 0;
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::main_of(std::vector<std::string>(argv + 1, argv + argc));
}
