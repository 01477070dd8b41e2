// Measures pictures per second of a displaced mesh, and the time from a dab of the brush to its
// picture, without a window: draw_bench [TRIANGLES [PICTURES]]

#include <cmath>
#include <cstdio>
#include <string>

#include <epoxy/gl.h>

#include "client/gl/context_egl.h"
#include "client/gl/gl_renderer.h"
#include "client/scene/displaced_surface.h"
#include "client/tools/cell_tint.h"
#include "common/generate/generate.h"
#include "tests/bench/timing.h"
#include "tests/client/scene/gridded_sphere.h"

namespace burnish {
namespace {

constexpr ImageSize kSize{1280, 720};
constexpr int kDepth = 8;

// Returns a move of some cells to and fro, like a strong edit.
Vec3f wave(const Vec3d& corner) {
  return Vec3d(std::sin(0.1 * corner.y()), std::cos(0.15 * corner.z()), std::sin(0.2 * corner.x()))
      .cast<float>();
}

/// A mesh that is drawn many times.
class Bench {
 public:
  static Result<Bench> create(const View& view) {
    ASSIGN_OR_RETURN(auto renderer, GlRenderer::create());
    Bench bench(std::move(renderer), view);
    RETURN_IF_ERROR(bench.renderer_->upload_mesh(bench.mesh_));
    return bench;
  }

  /// Uploads a frame that changes every corner, like a key frame.
  Status upload(const std::vector<Vec3f>& displacements) {
    displacements_ = displacements;
    const IndexRange all{0, displacements.size()};
    return renderer_->upload_displacements(displacements, {&all, 1});
  }

  /// Draws from a slightly turned camera.
  Status turn() {
    camera_ = turned(camera_, 1, 0);
    return draw();
  }

  /// Returns the point of the surface under the pointer, which moves a little.
  Result<Vec3d> look() {
    x_ = kSize.width / 2 - 100 + (x_ + 7) % 200;
    const Eigen::Vector2i pixel(x_, kSize.height / 2);
    ASSIGN_OR_RETURN(const auto triangle, renderer_->pick(camera_, kSize, pixel, false));
    if (!triangle) return not_found("nothing lies under the pointer");
    const Ray ray = pixel_ray(camera_, kSize, pixel.cast<double>() + Eigen::Vector2d(0.5, 0.5));
    const auto hit = point_on_triangle({mesh_, displacements_}, ray, *triangle);
    return hit ? hit->original : Vec3d::Zero();
  }

  /// Does all work between a move of the mouse and its picture: the surface under the pointer, the
  /// cells in reach of the brush, the ring around it.
  Status dab() {
    const Brush brush{.radius = 0.06 * mesh_.unit(), .strength = 0.6, .beta = 0};
    ASSIGN_OR_RETURN(const Vec3d point, look());
    const IndexRange changed = tint_.add_dab(brush, point);
    RETURN_IF_ERROR(renderer_->upload_cell_tint(tint_.weights(), changed));
    style_.rings = {{point, brush.radius}};
    return draw();
  }

 private:
  Bench(std::unique_ptr<GlRenderer> renderer, const View& view)
      : renderer_(std::move(renderer)),
        mesh_(make_view_mesh(view)),
        tint_(view),
        camera_(frame_all({}, mesh_.box, kSize.aspect())) {}

  Status draw() {
    RETURN_IF_ERROR(renderer_->draw(camera_, kSize, style_));
    glFinish();
    return Status::ok();
  }

  std::unique_ptr<GlRenderer> renderer_;
  ViewMesh mesh_;
  CellTint tint_;
  std::vector<Vec3f> displacements_;
  Camera camera_;
  DrawStyle style_;
  int x_ = 0;
};

void report(const char* what, double ms) {
  std::printf("%-28s %9.3f ms median, %8.1f pictures/s\n", what, ms, 1000 / ms);
}

Status run(uint64_t triangles, int pictures) {
  constexpr int kWarmUp = 3;
  ASSIGN_OR_RETURN(const auto context, EglContext::create());
  ASSIGN_OR_RETURN(const TriangleMesh scan,
                   generate_scan({.kind = "blob", .vertices = triangles / 2}));
  const View view = make_gridded_view(scan, kDepth);
  ASSIGN_OR_RETURN(Bench bench, Bench::create(view));
  std::vector<Vec3f> frames[2] = {displace_corners(view, wave), {}};
  for (const Vec3f& displacement : frames[0]) frames[1].push_back(-displacement);
  std::printf("%s\n%zu triangles, %zu corners at depth %d, %dx%d\n",
              reinterpret_cast<const char*>(glGetString(GL_RENDERER)), view.triangles.size(),
              frames[0].size(), kDepth, kSize.width, kSize.height);
  RETURN_IF_ERROR(bench.upload(frames[0]));
  Status status;
  const auto keep = [&status](const Status& each) { status = status.is_ok() ? each : status; };
  report("turning", median_milliseconds(pictures, kWarmUp, [&] { keep(bench.turn()); }));
  int number = 0;
  report("turning, all corners changed", median_milliseconds(pictures, kWarmUp, [&] {
           keep(bench.upload(frames[++number % 2]));
           keep(bench.turn());
         }));
  report("what lies under the pointer",
         median_milliseconds(pictures, kWarmUp, [&] { keep(bench.look().status()); }));
  report("from a dab to its picture",
         median_milliseconds(pictures, kWarmUp, [&] { keep(bench.dab()); }));
  return status;
}

}  // namespace
}  // namespace burnish

int main(int count, char** words) {
  const uint64_t triangles = count > 1 ? std::stoull(words[1]) : 1'000'000;
  const int pictures = count > 2 ? std::stoi(words[2]) : 30;
  const burnish::Status status = burnish::run(triangles, pictures);
  if (!status.is_ok()) std::fprintf(stderr, "draw_bench: %s\n", status.message().c_str());
  return status.is_ok() ? 0 : 1;
}
