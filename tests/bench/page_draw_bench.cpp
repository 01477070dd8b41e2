// Pictures per second of a displaced mesh in pages, and how long a pick takes, without a window:
// page_draw_bench [TRIANGLES [PICTURES]]

#include <cmath>
#include <cstdio>
#include <string>

#include <epoxy/gl.h>

#include "client/gl/context_egl.h"
#include "client/gl/gl_page_renderer.h"
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
  static Result<Bench> create(const TriangleMesh& scan) {
    ASSIGN_OR_RETURN(auto renderer, GlPageRenderer::create());
    Bench bench(std::move(renderer), split_into_pages(scan, kPageTriangles));
    RETURN_IF_ERROR(bench.upload());
    return bench;
  }

  /// A frame that changes every vertex.
  Status move() {
    amplitude_ = -amplitude_;
    for (uint32_t slot = 0; slot < meshes_.size(); ++slot) {
      std::vector<Vec3f> moves;
      for (const Vec3f& at : meshes_[slot].positions)
        moves.emplace_back(amplitude_ * at.y(), amplitude_ * at.z(), amplitude_ * at.x());
      const MovedPage moved = displace(meshes_[slot], moves, space_.cell_size);
      RETURN_IF_ERROR(renderer_->move_page(slot, moves, moved));
    }
    return Status::ok();
  }

  /// From a little further round.
  Status turn() {
    camera_ = turned(camera_, 1, 0);
    RETURN_IF_ERROR(renderer_->draw(camera_, kSize, {}, patches_));
    glFinish();
    return Status::ok();
  }

  Status look() {
    x_ = kSize.width / 2 - 100 + (x_ + 7) % 200;
    return renderer_->pick(camera_, kSize, {x_, kSize.height / 2}, false, patches_).status();
  }

  Status upload() {
    renderer_->open(space_);
    RETURN_IF_ERROR(renderer_->reserve(static_cast<uint32_t>(meshes_.size())));
    for (uint32_t slot = 0; slot < meshes_.size(); ++slot)
      RETURN_IF_ERROR(renderer_->upload_page(slot, meshes_[slot]));
    return Status::ok();
  }

  size_t pages() const { return meshes_.size(); }

 private:
  Bench(std::unique_ptr<GlPageRenderer> renderer, const SplitMesh& split)
      : renderer_(std::move(renderer)), space_(make_page_space(split.grid, kDepth)) {
    Eigen::AlignedBox3d box;
    for (const Vec3d& vertex : split.rounded.vertices) box.extend(vertex);
    camera_ = frame_all({}, box, kSize.aspect());
    for (const Page& page : split.pages) {
      const auto slot = static_cast<uint32_t>(meshes_.size());
      patches_.push_back({slot, 0, static_cast<uint32_t>(page.triangles.size())});
      meshes_.push_back(make_page_mesh(page, split.grid));
    }
  }

  std::unique_ptr<GlPageRenderer> renderer_;
  PageSpace space_;
  std::vector<PageMesh> meshes_;
  std::vector<PatchRange> patches_;
  Camera camera_;
  float amplitude_ = 1;
  int x_ = 0;
};

Status run(uint64_t triangles, int pictures) {
  constexpr int kWarmUp = 3;
  ASSIGN_OR_RETURN(const auto context, EglContext::create());
  ASSIGN_OR_RETURN(const TriangleMesh scan,
                   generate_scan({.kind = "blob", .vertices = triangles / 2}));
  ASSIGN_OR_RETURN(Bench bench, Bench::create(scan));
  std::printf("%s\n%zu triangles in %zu pages, %dx%d\n",
              reinterpret_cast<const char*>(glGetString(GL_RENDERER)), scan.triangles.size(),
              bench.pages(), kSize.width, kSize.height);
  Status status;
  const auto report = [&](const char* what, const auto& work) {
    const double ms = median_milliseconds(pictures, kWarmUp, [&] {
      const Status done = work();
      if (!done.is_ok()) status = done;
    });
    std::printf("%-28s %9.3f ms median\n", what, ms);
  };
  report("turning", [&] { return bench.turn(); });
  report("all pages moved", [&] { return bench.move(); });
  report("all pages uploaded", [&] { return bench.upload(); });
  report("what lies under the pointer", [&] { return bench.look(); });
  return status;
}

}  // namespace
}  // namespace burnish

int main(int count, char** words) {
  const uint64_t triangles = count > 1 ? std::stoull(words[1]) : 1'000'000;
  const int pictures = count > 2 ? std::stoi(words[2]) : 30;
  const burnish::Status status = burnish::run(triangles, pictures);
  if (!status.is_ok()) std::fprintf(stderr, "page_draw_bench: %s\n", status.message().c_str());
  return status.is_ok() ? 0 : 1;
}
