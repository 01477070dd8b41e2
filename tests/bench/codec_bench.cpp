// Measures bytes and milliseconds of frames on one core: key frame, slider step, curve step, brush
// dab and the still frames after them; as coefficients, as vertices, and for a proxy; next to other
// encodings. Then measures frames by page, for levels of detail.
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
#include "common/evaluation/proxy.h"
#include "common/frame_codec/frame_decoder.h"
#include "common/frame_codec/frame_encoder.h"
#include "common/generate/generate.h"
#include "common/mesh/mesh_io.h"
#include "server/prepare/prepare.h"
#include "server/session/session.h"
#include "server/solver/tuning/plan_cycle.h"
#include "tests/bench/codec_alternatives.h"
#include "tests/bench/codec_pages.h"

namespace burnish {
namespace {

using nlohmann::ordered_json;

constexpr uint64_t kGeneratedVertices = 200'000;
constexpr size_t kProxyTriangles = 50'000;
constexpr int kRepeats = 7;

/// A displacement in an editing session, and how it is sent.
struct Scene {
  std::string name;
  FrameStep step;
  bool is_key;
  std::vector<Vec3f> displacement;
};

template <typename Work>
double median_milliseconds(Work&& work) {
  std::vector<double> times(kRepeats);
  for (double& time : times) {
    const auto start = std::chrono::steady_clock::now();
    work();
    time =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  }
  std::nth_element(times.begin(), times.begin() + kRepeats / 2, times.end());
  return times[kRepeats / 2];
}

TriangleMesh load(const std::string& scan) {
  for (const GeneratedScanKind& kind : generated_scan_kinds())
    if (kind.name == scan)
      return generate_scan({.kind = scan, .vertices = kGeneratedVertices}).value();
  return read_mesh(scan).value();
}

/// Plays an editing session and keeps the displacement of every frame.
class Scenes {
 public:
  explicit Scenes(Session& session) : session_(session) {}

  std::vector<Scene> play() {
    const PreparedMesh& prepared = session_.prepared();
    edit(SetTransferCurve{TransferCurve(20)});
    edit(SetGradientScale{0});
    settle("key frame, settled", true);
    scenes_.push_back(scenes_.back());
    scenes_.back().name = "key frame, moving";
    scenes_.back().step = FrameStep::kMoving;
    edit(SetGradientScale{0.02});
    step("slider step of 0.02");
    edit(SetGradientScale{0.1});
    step("slider step of 0.08");
    settle("its still frame");
    edit(SetTransferCurve{TransferCurve::parse("-20:16,20:20").value()});
    step("curve step");
    settle("its still frame");
    Stroke dab;
    dab.brush = {.radius = 0.01 * prepared.statistics.diagonal(), .beta = 2};
    dab.path = {prepared.vertices[prepared.vertices.size() / 2]};
    edit(dab);
    step("brush dab");
    step("one cycle later");
    settle("its still frame");
    return std::move(scenes_);
  }

 private:
  std::vector<Vec3f> shown() const {
    const std::span<const Vec3f> u = session_.solver().displacement();
    return {u.begin(), u.end()};
  }
  template <typename Change>
  void edit(Change change) {
    const Status status = session_.apply({std::to_string(edits_++), std::move(change)});
    BURNISH_CHECK(status.is_ok(), status.message());
  }
  void step(const std::string& name) {
    session_.step();
    scenes_.push_back({name, FrameStep::kMoving, false, shown()});
  }
  void settle(const std::string& name, bool is_key = false) {
    BURNISH_CHECK(session_.solve({}).is_ok(), "nobody cancels");
    scenes_.push_back({name, FrameStep::kStill, is_key, shown()});
  }

  Session& session_;
  std::vector<Scene> scenes_;
  int edits_ = 0;
};

// Returns the largest distance, in cells, between a client's picture and the right one.
double vertex_error(const FrameLayout& layout, const FrameMesh& mesh, const FrameState& state,
                    const std::vector<Vec3f>& displacement) {
  const bool coefficients = layout.content == FrameContent::kCoefficients;
  std::vector<Vec3f> shown(coefficients ? mesh.grid.corners.size() : mesh.points.size(),
                           Vec3f::Zero());
  for (int tile = 0; tile < layout.tile_count(); ++tile)
    write_displacement(layout, state, tile, shown);
  double largest = 0;
  for (size_t v = 0; v < mesh.points.size(); ++v) {
    const Vec3f wanted = evaluate<Vec3f>(mesh.grid, mesh.points[v], displacement);
    const Vec3f at_vertex =
        coefficients ? evaluate<Vec3f>(mesh.grid, mesh.points[v], shown) : shown[v];
    largest = std::max(largest, double{(at_vertex - wanted).lpNorm<Eigen::Infinity>()});
  }
  return largest;
}

void report_alternatives(const FrameLayout& layout, const FrameState& reference,
                         const FrameSample& sample, const Scene& scene, ordered_json& out) {
  const auto costs = alternative_costs(layout, reference, sample, static_cast<int>(scene.step));
  for (const AlternativeCost& cost : costs) {
    std::printf(" |%8.1f KB%6.1f ms", static_cast<double>(cost.bytes) * 1e-3, cost.milliseconds);
    out["alternatives"].push_back(
        {{"name", cost.name}, {"bytes", cost.bytes}, {"encode_ms", cost.milliseconds}});
  }
  std::printf("\n");
}

/// Sends the scenes to one client that acknowledges each.
void report_client(const std::string& name, const FrameLayout& client_layout, const FrameMesh& mesh,
                   const std::vector<Scene>& scenes, ordered_json& out) {
  const auto layout = std::make_shared<const FrameLayout>(client_layout);
  FrameEncoder encoder(layout);
  FrameDecoder decoder(layout);
  std::printf("  %s: %d values in %d tiles\n", name.c_str(), layout->value_count(),
              layout->tile_count());
  std::printf("    %-20s    tiles      bytes  round  encode  decode   off by |%21s |%21s |%21s\n",
              "", "int16 + zstd", "byte planes + zstd", "meshopt + zstd");
  for (const Scene& scene : scenes) {
    if (scene.is_key) encoder.request_key_frame();
    FrameSample sample;
    const double rounding = median_milliseconds(
        [&] { sample = sample_displacement<Vec3f>(*layout, mesh, scene.displacement).value(); });
    EncodedFrame frame;
    const double encoding =
        median_milliseconds([&] { frame = encoder.encode(sample, scene.step); });
    const FrameState reference =
        frame.reference == 0 ? FrameState(*layout) : *encoder.sent_state(frame.reference);
    FrameDecoder decoded = decoder;
    const double decoding = median_milliseconds([&] {
      decoded = decoder;
      BURNISH_CHECK(decoded.decode(frame.bytes).is_ok(), "our own frame");
    });
    decoder = decoded;
    encoder.acknowledge(frame.sequence);
    const double error = vertex_error(*layout, mesh, decoder.state(), scene.displacement);
    std::printf("    %-20s%5u/%3d%8.1f KB%7.2f%8.2f%8.2f   1/%4.0f", scene.name.c_str(),
                frame.sent_tiles, layout->tile_count(),
                static_cast<double>(frame.bytes.size()) * 1e-3, rounding, encoding, decoding,
                1 / error);
    ordered_json row = {{"layout", name},
                        {"scene", scene.name},
                        {"tiles", frame.sent_tiles},
                        {"bytes", frame.bytes.size()},
                        {"round_ms", rounding},
                        {"encode_ms", encoding},
                        {"decode_ms", decoding},
                        {"vertex_error_cells", error}};
    report_alternatives(*layout, reference, sample, scene, row);
    out["frames"].push_back(std::move(row));
  }
  std::printf("    encoder remembers %.1f MB\n", static_cast<double>(encoder.byte_count()) * 1e-6);
}

const Scene& scene_of(const std::vector<Scene>& scenes, const std::string& name) {
  return *std::ranges::find(scenes, name, &Scene::name);
}

/// Frames by page, for clients that show the whole surface at some level of detail.
void report_pages(const PreparedMesh& prepared, const SparseGrid& grid,
                  const std::vector<Scene>& scenes, ordered_json& out) {
  std::printf("  frames by page: key, and a slider step of 0.02; bytes a vertex of the pages\n");
  std::printf(
      "    level  pages vertices  kind      values a vertex  step     key  slider"
      "  sample  encode  decode\n");
  for (const PageLevel& level : build_page_levels(prepared)) {
    size_t vertices = 0;
    for (const Page& page : level.pages) vertices += page.positions.size();
    for (const PageFrameKind kind : {PageFrameKind::kVertices, PageFrameKind::kCorners})
      for (const int shift : {2, 0}) {
        const PageFrameCost cost = page_frame_cost(
            level, grid, kind, shift, scene_of(scenes, "key frame, settled").displacement,
            scene_of(scenes, "slider step of 0.02").displacement);
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
  const std::vector<Scene> scenes = Scenes(*session).play();
  std::printf("%s, depth %d: %zu vertices, %d corners; median of %d, one core, milliseconds\n",
              scan.c_str(), depth, prepared->vertices.size(), grid.corner_count(), kRepeats);
  ordered_json out = {{"scan", scan},
                      {"depth", depth},
                      {"vertices", prepared->vertices.size()},
                      {"corners", grid.corner_count()}};
  use_threads(1);
  const FrameMesh full = {grid, prepared->evaluation};
  report_client("coefficients", make_coefficient_layout(full), full, scenes, out);
  report_client("vertices", make_vertex_layout(full), full, scenes, out);
  report_pages(*prepared, grid, scenes, out);

  Proxy proxy;
  const double making = median_milliseconds([&] {
    proxy = make_proxy({prepared->vertices, prepared->triangles, prepared->evaluation},
                       kProxyTriangles);
  });
  const FrameMesh thin = {grid, proxy.evaluation};
  std::printf("  proxy of %zu triangles in %.0f ms\n", proxy.triangles.size(), making);
  out["proxy_ms"] = making;
  report_client("proxy, smaller layout", make_smaller_layout(thin), thin, scenes, out);
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
