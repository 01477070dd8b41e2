// Measures bytes and milliseconds of frames on one core, of both kinds, for clients that show the
// whole surface at a level of detail: a key frame, and a slider step.
//
//     codec_bench [--json FILE] [SCAN DEPTH]...
//
// SCAN is a mesh file or the kind of a generated scan of 200,000 vertices; without any: blob 8
// tablet 8.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>
#include <thread>

#include <nlohmann/json.hpp>

#include "common/base/parallel.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "server/prepare/prepare.h"
#include "server/session/session.h"
#include "server/solver/tuning/plan_cycle.h"
#include "tests/bench/codec_pages.h"

namespace burnish {
namespace {

using nlohmann::ordered_json;

constexpr uint64_t kGeneratedVertices = 200'000;

TriangleMesh load(const std::string& scan) {
  for (const GeneratedScanKind& kind : generated_scan_kinds())
    if (kind.name == scan)
      return generate_scan({.kind = scan, .vertices = kGeneratedVertices}).value();
  return read_mesh(scan).value();
}

/// Displacements of the corners of a session.
struct Scenes {
  std::vector<Vec3f> settled;
  std::vector<Vec3f> slider_step;  ///< after it: one cycle of a step of 0.02
};

std::vector<Vec3f> shown(const Session& session) {
  const std::span<const Vec3f> u = session.solver().displacement();
  return {u.begin(), u.end()};
}

Scenes play(Session& session) {
  int edits = 0;
  const auto edit = [&](auto change) {
    const Status status = session.apply({std::to_string(edits++), std::move(change)});
    BURNISH_CHECK(status.is_ok(), status.message());
  };
  Scenes scenes;
  edit(SetTransferCurve{TransferCurve(20)});
  edit(SetGradientScale{0});
  BURNISH_CHECK(session.solve({}).is_ok(), "nobody cancels");
  scenes.settled = shown(session);
  edit(SetGradientScale{0.02});
  session.step();
  scenes.slider_step = shown(session);
  return scenes;
}

/// Frames by page, for clients that show the whole surface at some level of detail.
void report_pages(const PreparedMesh& prepared, const SparseGrid& grid, const Scenes& scenes,
                  ordered_json& out) {
  std::printf("  frames by page: key, and a slider step of 0.02; bytes a vertex of the pages\n");
  std::printf(
      "    level  pages vertices  kind      values a vertex  step     key  slider"
      "  sample  encode  decode\n");
  for (const PageLevel& level : build_page_levels(prepared)) {
    size_t vertices = 0;
    for (const Page& page : level.pages) vertices += page.positions.size();
    for (const PageFrameKind kind : {PageFrameKind::kVertices, PageFrameKind::kCorners})
      for (const int shift : {2, 0}) {
        const PageFrameCost cost =
            page_frame_cost(level, grid, kind, shift, scenes.settled, scenes.slider_step);
        const auto a_vertex = [&](size_t count) {
          return static_cast<double>(count) / static_cast<double>(vertices);
        };
        const char* name = kind == PageFrameKind::kVertices ? "vertices" : "corners";
        std::printf("    %5d %6zu %8zu  %-8s %16.2f 1/%3d %8.2f%8.2f%8.2f%8.2f%8.2f\n", level.level,
                    level.pages.size(), vertices, name, a_vertex(cost.values), 256 >> shift,
                    a_vertex(cost.key_bytes), a_vertex(cost.change_bytes), cost.sample_ms,
                    cost.encode_ms, cost.decode_ms);
        out["pages"].push_back({{"level", level.level},
                                {"pages", level.pages.size()},
                                {"vertices", vertices},
                                {"kind", name},
                                {"values", cost.values},
                                {"step_shift", shift},
                                {"key_bytes", cost.key_bytes},
                                {"slider_bytes", cost.change_bytes},
                                {"sample_ms", cost.sample_ms},
                                {"encode_ms", cost.encode_ms},
                                {"decode_ms", cost.decode_ms}});
      }
  }
}

ordered_json run(const std::string& scan, int depth) {
  const auto prepared = prepare(load(scan), {.depth = depth}).value();
  const Multigrid multigrid = make_multigrid(prepared).value();
  const SparseGrid& grid = multigrid.hierarchy->depths.back().grid;
  const auto session = Session::open(multigrid, {}).value();
  const Scenes scenes = play(*session);
  std::printf("%s, depth %d: %zu vertices, %d corners; one core, milliseconds\n", scan.c_str(),
              depth, prepared->vertices.size(), grid.corner_count());
  ordered_json out = {{"scan", scan},
                      {"depth", depth},
                      {"vertices", prepared->vertices.size()},
                      {"corners", grid.corner_count()}};
  use_threads(1);
  report_pages(*prepared, grid, scenes, out);

  use_threads(std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
  return out;
}

int main_of(const std::vector<std::string>& arguments) {
  std::vector<std::string> scans;
  std::string json_file;
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--json" && i + 1 < arguments.size())
      json_file = arguments[++i];
    else
      scans.push_back(arguments[i]);
  }
  if (scans.empty()) scans = {"blob", "8", "tablet", "8"};
  if (scans.size() % 2 != 0) {
    std::cerr << "usage: codec_bench [--json FILE] [SCAN DEPTH]...\n";
    return 2;
  }
  ordered_json report;
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
