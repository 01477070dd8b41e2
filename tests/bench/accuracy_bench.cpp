// Measures every row of the accuracy table (docs/solver.md, "How exact"): the distance of a
// session's vertices from the converged surface when it is settled, exact, and after a number of
// frames.
//
//     accuracy_bench [--json FILE] [--rows TEXT] [--soak] [SCAN[@DEPTH]]...
//
// SCAN is a mesh file or KIND:VERTICES of a generated scan; without any: every kind. The default
// depth is the scan's, the backend is CUDA if there is a device. --rows keeps the rows whose name
// contains TEXT. --soak leaves converged sessions idle for 2,000 frames instead. Exits with 1 if a
// bar is missed.

#include <cstdio>
#include <fstream>
#include <iostream>

#include <nlohmann/json.hpp>

#include "common/generate/generate.h"
#include "server/prepare/prepare.h"
#include "server/session/session.h"
#include "server/solver/cuda/cuda_backend.h"
#include "server/solver/tuning/plan_cycle.h"
#include "tests/bench/accuracy_converged.h"
#include "tests/bench/accuracy_runs.h"
#include "tests/bench/accuracy_soak.h"
#include "tests/bench/input.h"
#include "tests/reference/compare.h"

namespace burnish {
namespace {

using nlohmann::ordered_json;
using Kind = AccuracyStop::Kind;

constexpr const char* kVerticesOfAKind = ":60000";

struct Options {
  std::string json_file;
  std::string rows;
  bool soak = false;
  std::vector<std::string> scans;
};

struct Scan : Multigrid {
  std::string name;
  TriangleMesh mesh;
};

Result<Scan> open_scan(const std::string& text) {
  ASSIGN_OR_RETURN(const ScanArgument argument, parse_scan(text));
  Scan scan;
  scan.name = argument.name();
  ASSIGN_OR_RETURN(scan.mesh, load_mesh(argument));
  ASSIGN_OR_RETURN(const auto prepared,
                   prepare(scan.mesh, {.depth = depth_of(argument, scan.mesh)}));
  ASSIGN_OR_RETURN(static_cast<Multigrid&>(scan), make_multigrid(prepared));
  std::printf("%s, depth %d: %zu vertices, %d corners, on %s\n", scan.name.c_str(),
              scan.prepared->frame.depth, scan.mesh.vertices.size(),
              scan.hierarchy->at(scan.hierarchy->finest).grid.corner_count(),
              cuda_device().is_ok() ? "CUDA" : "the CPU");
  return scan;
}

/// A session and its frames since its last edit.
struct Live {
  std::unique_ptr<Session> session;
  int edits = 0;
  int frames = 0;

  void apply(const Changes& changes) {
    for (const auto& change : changes) {
      const Status status = session->apply({std::to_string(edits++), change});
      BURNISH_CHECK(status.is_ok(), status.message());
    }
    frames = 0;
  }

  void go_to(const AccuracyStop& stop) {
    if (stop.kind == Kind::kFrames)
      for (; frames < stop.frames; ++frames) session->step();
    else
      frames += session->solve({.exact = stop.kind == Kind::kExact}).value().cycles;
  }
};

std::string label(const AccuracyStop& stop, int frames) {
  if (stop.kind == Kind::kFrames) return std::to_string(frames) + " frames";
  return (stop.kind == Kind::kExact ? "exact (" : "settled (") + std::to_string(frames) + ")";
}

/// Prints one row. Returns true if it misses a bar.
bool report(const AccuracyRun& run, const AccuracyStop& stop, int frames,
            const reference::Distance& distance, const ConvergedSurface& converged,
            ordered_json& rows) {
  const bool met = distance.max <= stop.max && (stop.rms == 0 || distance.rms <= stop.rms);
  std::printf("  %-24s %-14s max %.1e of %.0e  rms %.1e", run.name.c_str(),
              label(stop, frames).c_str(), distance.max, stop.max, distance.rms);
  if (stop.rms > 0)
    std::printf(" of %.0e", stop.rms);
  else
    std::printf("         ");
  std::printf("  %-6s  %s to %.0e\n", met ? "met" : "MISSED", converged.method.c_str(),
              converged.known_to);
  std::fflush(stdout);
  rows.push_back({{"row", run.name},
                  {"stop", label(stop, 0)},
                  {"frames", frames},
                  {"max", distance.max},
                  {"max_bar", stop.max},
                  {"rms", distance.rms},
                  {"rms_bar", stop.rms},
                  {"met", met},
                  {"converged_by", converged.method},
                  {"converged_known_to", converged.known_to}});
  return !met;
}

int measure(const Scan& scan, const AccuracyRun& run, Converged& converged, ordered_json& rows) {
  Live live{Session::open(scan, {}).value()};
  if (!run.settled_with.empty()) {
    live.apply(run.settled_with);
    live.go_to({.kind = Kind::kSettled});
  }
  live.apply(run.then);
  const ConvergedSurface answer = converged.of(*live.session);
  int missed = 0;
  for (const AccuracyStop& stop : run.stops) {
    live.go_to(stop);
    const auto distance = reference::vertex_distance(
        live.session->surface().vertices, answer.vertices, scan.prepared->statistics.diagonal());
    missed += report(run, stop, live.frames, distance, answer, rows);
  }
  return missed;
}

int bench(const Scan& scan, const Options& options, ordered_json& out) {
  Converged converged(scan.mesh, scan);
  int missed = 0;
  for (const AccuracyRun& run : accuracy_runs(*scan.prepared))
    if (run.name.find(options.rows) != std::string::npos)
      missed += measure(scan, run, converged, out["rows"]);
  return missed;
}

Options parse(const std::vector<std::string>& arguments) {
  Options options;
  for (size_t i = 0; i < arguments.size(); ++i) {
    const bool has_next = i + 1 < arguments.size();
    if (arguments[i] == "--json" && has_next)
      options.json_file = arguments[++i];
    else if (arguments[i] == "--rows" && has_next)
      options.rows = arguments[++i];
    else if (arguments[i] == "--soak")
      options.soak = true;
    else
      options.scans.push_back(arguments[i]);
  }
  if (options.scans.empty())
    for (const GeneratedScanKind& kind : generated_scan_kinds())
      options.scans.push_back(std::string(kind.name) + kVerticesOfAKind);
  return options;
}

/// Returns how many rows missed their bar.
Result<int> run(const Options& options) {
  ordered_json report;
  int missed = 0;
  for (const std::string& argument : options.scans) {
    ASSIGN_OR_RETURN(const Scan scan, open_scan(argument));
    ordered_json out = {{"scan", scan.name}, {"depth", scan.prepared->frame.depth}};
    missed += options.soak ? soak(scan, out) : bench(scan, options, out);
    report["scans"].push_back(std::move(out));
  }
  std::printf("%d rows missed\n", missed);
  report["missed"] = missed;
  if (!options.json_file.empty()) std::ofstream(options.json_file) << report.dump(2) << "\n";
  return missed;
}

int main_of(const Options& options) {
  const Result<int> missed = run(options);
  if (missed.is_ok()) return missed.value() > 0;
  std::cerr << "accuracy_bench: " << missed.status().message() << "\n";
  return 2;
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::main_of(burnish::parse(std::vector<std::string>(argv + 1, argv + argc)));
}
