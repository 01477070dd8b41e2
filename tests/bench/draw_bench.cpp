// Pictures per second of a displaced mesh, without a window: draw_bench [TRIANGLES [PICTURES]]

#include <cmath>
#include <cstdio>
#include <string>

#include <epoxy/gl.h>

#include "client/gl/context_egl.h"
#include "client/gl/gl_renderer.h"
#include "common/mesh/generate.h"
#include "tests/bench/timing.h"
#include "tests/client/gridded_sphere.h"

namespace burnish {
namespace {

constexpr ImageSize kSize{1280, 720};
constexpr int kDepth = 8;

// Some cells to and fro: as a strong edit moves a surface.
Vec3f wave(const Vec3d& corner) {
  return Vec3d(std::sin(0.1 * corner.y()), std::cos(0.15 * corner.z()), std::sin(0.2 * corner.x()))
      .cast<float>();
}

/// Draws the mesh again and again, each time from a little further round.
class Bench {
 public:
  static Result<Bench> create(const ViewMesh& mesh) {
    ASSIGN_OR_RETURN(auto renderer, GlRenderer::create());
    RETURN_IF_ERROR(renderer->upload_mesh(mesh));
    return Bench(std::move(renderer), frame_all({}, mesh.box, kSize.aspect()));
  }

  /// A frame that changes every corner, as the whole of a keyframe does.
  Status upload(const std::vector<Vec3f>& displacements) {
    const IndexRange all{0, displacements.size()};
    return renderer_->upload_displacements(displacements, {&all, 1});
  }

  Status draw() {
    camera_ = turned(camera_, 1, 0);
    RETURN_IF_ERROR(renderer_->draw(camera_, kSize, {}));
    glFinish();
    return Status::ok();
  }

 private:
  Bench(std::unique_ptr<GlRenderer> renderer, const Camera& camera)
      : renderer_(std::move(renderer)), camera_(camera) {}

  std::unique_ptr<GlRenderer> renderer_;
  Camera camera_;
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
  ASSIGN_OR_RETURN(Bench bench, Bench::create(make_view_mesh(view)));
  std::vector<Vec3f> frames[2] = {displace_corners(view, wave), {}};
  for (const Vec3f& displacement : frames[0]) frames[1].push_back(-displacement);
  std::printf("%s\n%zu triangles, %zu corners at depth %d, %dx%d\n",
              reinterpret_cast<const char*>(glGetString(GL_RENDERER)), view.triangles.size(),
              frames[0].size(), kDepth, kSize.width, kSize.height);
  RETURN_IF_ERROR(bench.upload(frames[0]));
  Status status;
  const auto keep = [&status](const Status& each) { status = status.is_ok() ? each : status; };
  report("turning", median_milliseconds(pictures, kWarmUp, [&] { keep(bench.draw()); }));
  int number = 0;
  report("turning, all corners changed", median_milliseconds(pictures, kWarmUp, [&] {
           keep(bench.upload(frames[++number % 2]));
           keep(bench.draw());
         }));
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
