// Measures pictures per second of a displaced mesh in pages, the time from a dab of the brush to
// its picture, and picks, without a window: draw_bench [TRIANGLES [PICTURES [FILE]]]
//
// Adds its figures to FILE, draw_bench.json for tests/bench/write_tables.

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <epoxy/gl.h>
#include <nlohmann/json.hpp>

#include "client/gl/context_egl.h"
#include "client/gl/gl_page_renderer.h"
#include "client/scene/null_page_renderer.h"
#include "client/scene/page_surface.h"
#include "client/scene/raw_pages.h"
#include "common/generate/generate.h"
#include "tests/bench/timing.h"
#include "tests/client/scene/page_splitter.h"

namespace burnish {
namespace {

constexpr ImageSize kSize{1280, 720};
constexpr int kDepth = 8;
constexpr size_t kPageTriangles = 3500;

/// Pages that are drawn again and again.
class Bench {
 public:
  Bench(PageRenderer& renderer, const SplitMesh& split)
      : renderer_(renderer), surface_(renderer), space_(make_page_space(split.grid, kDepth)) {
    Eigen::AlignedBox3d box;
    for (const Vec3d& vertex : split.rounded.vertices) box.extend(vertex);
    camera_ = frame_all({}, box, kSize.aspect());
    for (const Page& page : split.pages) {
      const auto slot = static_cast<uint32_t>(meshes_.size());
      patches_.push_back({slot, 0, static_cast<uint32_t>(page.triangles.size())});
      meshes_.push_back(make_page_mesh(page, split.grid));
    }
  }

  Status put_all() {
    surface_.open(space_);
    RETURN_IF_ERROR(surface_.reserve(static_cast<uint32_t>(meshes_.size())));
    for (uint32_t slot = 0; slot < meshes_.size(); ++slot)
      RETURN_IF_ERROR(surface_.put(slot, meshes_[slot]));
    return draw();
  }

  /// A frame that moves every vertex to and fro, and a picture from a turned camera.
  Status move_all() {
    amplitude_ = -amplitude_;
    for (uint32_t slot = 0; slot < meshes_.size(); ++slot) move(slot);
    return turn();
  }

  /// Draws from a slightly turned camera.
  Status turn() {
    camera_ = turned(camera_, 1, 0);
    return draw();
  }

  /// Finds what lies under the pointer, which moves a little.
  Result<PageHit> look() {
    x_ = kSize.width / 2 - 100 + (x_ + 7) % 200;
    const auto hit =
        surface_.hit(pixel_ray(camera_, kSize, {x_ + 0.5, kSize.height / 2 + 0.5}), false);
    if (!hit) return not_found("nothing lies under the pointer");
    return *hit;
  }

  /// Does all work between a move of the mouse and its picture: the surface under the pointer, the
  /// tint of its page, the ring around it, and the page's new displacements.
  Status dab() {
    ASSIGN_OR_RETURN(const PageHit hit, look());
    const size_t vertices = meshes_[hit.slot].positions.size();
    const std::vector<VertexMark> marks(vertices, VertexMark{0, 120});
    RETURN_IF_ERROR(renderer_.mark_page(hit.slot, marks));
    style_.rings = {{hit.point.original, 0.06 * space_.unit}};
    amplitude_ = -amplitude_;
    move(hit.slot);
    return draw();
  }

  size_t pages() const { return meshes_.size(); }

 private:
  void move(uint32_t slot) {
    std::vector<Vec3f> moves;
    for (const Vec3f& at : meshes_[slot].positions)
      moves.emplace_back(amplitude_ * std::sin(20 * at.y()), amplitude_ * std::cos(15 * at.z()),
                         amplitude_ * std::sin(30 * at.x()));
    surface_.move(slot, std::move(moves));
  }

  Status draw() {
    RETURN_IF_ERROR(surface_.draw(camera_, kSize, style_, patches_));
    glFinish();
    return Status::ok();
  }

  PageRenderer& renderer_;
  PageSurface surface_;
  PageSpace space_;
  std::vector<PageMesh> meshes_;
  std::vector<PatchRange> patches_;
  Camera camera_;
  DrawStyle style_;
  float amplitude_ = 1;
  int x_ = 0;
};

/// Times works, and keeps the first failure.
class Table {
 public:
  explicit Table(int repeats) : repeats_(repeats) {}

  template <typename Work>
  void add(const char* what, const Work& work) {
    constexpr int kWarmUp = 3;
    const double ms = median_milliseconds(repeats_, kWarmUp, [&] {
      const Status done = work();
      if (!done.is_ok()) status_ = done;
    });
    std::printf("%-32s %9.3f ms median, %8.1f a second\n", what, ms, 1000 / ms);
    medians_ms_[what] = ms;
  }
  const Status& status() const { return status_; }
  const nlohmann::ordered_json& medians_ms() const { return medians_ms_; }

 private:
  int repeats_;
  Status status_;
  nlohmann::ordered_json medians_ms_;
};

Status add_to_file(const std::filesystem::path& path, nlohmann::ordered_json figures) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  if (std::ifstream before(path); before) all = nlohmann::ordered_json::parse(before);
  all.push_back(std::move(figures));
  std::ofstream file(path);
  file << all.dump(1) << "\n";
  return file.flush() ? Status::ok() : internal_error("cannot write " + path.string());
}

Status run(uint64_t triangles, int pictures, const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(const auto context, EglContext::create());
  ASSIGN_OR_RETURN(const TriangleMesh scan,
                   generate_scan({.kind = "blob", .vertices = triangles / 2}));
  ASSIGN_OR_RETURN(const auto renderer, GlPageRenderer::create());
  const SplitMesh split = split_into_pages(scan, kPageTriangles);
  Bench bench(*renderer, split);
  RETURN_IF_ERROR(bench.put_all());
  const char* const card = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  std::printf("%s\n%zu triangles in %zu pages, %dx%d\n", card, scan.triangles.size(), bench.pages(),
              kSize.width, kSize.height);
  Table table(pictures);
  table.add("turning", [&] { return bench.turn(); });
  table.add("turning, all pages moved", [&] { return bench.move_all(); });
  table.add("what lies under the pointer", [&] { return bench.look().status(); });
  table.add("from a dab to its picture", [&] { return bench.dab(); });
  table.add("all pages uploaded", [&] { return bench.put_all(); });
  NullPageRenderer nothing;
  Bench without(nothing, split);
  RETURN_IF_ERROR(without.put_all());
  RETURN_IF_ERROR(without.move_all());
  table.add("all pages moved, not drawn", [&] { return without.move_all(); });
  table.add("a mesh cut into pages", [&] {
    return make_raw_pages(scan).pages.empty() ? internal_error("no pages") : Status::ok();
  });
  if (!table.status().is_ok() || path.empty()) return table.status();
  return add_to_file(
      path,
      {{"card", card}, {"triangles", scan.triangles.size()}, {"medians_ms", table.medians_ms()}});
}

}  // namespace
}  // namespace burnish

int main(int count, char** words) {
  const uint64_t triangles = count > 1 ? std::stoull(words[1]) : 1'000'000;
  const int pictures = count > 2 ? std::stoi(words[2]) : 30;
  const burnish::Status status = burnish::run(triangles, pictures, count > 3 ? words[3] : "");
  if (!status.is_ok()) std::fprintf(stderr, "draw_bench: %s\n", status.message().c_str());
  return status.is_ok() ? 0 : 1;
}
