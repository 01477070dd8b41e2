// Measures pictures that processors draw (client/raster) beside those of OpenGL, turning around a
// scan at full detail: raster_bench [--pictures N] [--out FOLDER] [SCAN]
//
// SCAN is a mesh file or KIND:VERTICES. The difference is the root of the mean square, as a part of
// the full range, to OpenGL's picture of the same view.

#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>

#include <epoxy/gl.h>

#include "client/gl/context_egl.h"
#include "client/gl/gl_page_renderer.h"
#include "client/raster/raster_page_renderer.h"
#include "client/scene/png_writer.h"
#include "client/scene/raw_pages.h"
#include "common/generate/generate.h"
#include "common/mesh/mesh_io.h"
#include "tests/bench/timing.h"
#include "tests/client/raster/picture_rmse.h"

namespace burnish {
namespace {

constexpr ImageSize kSize{1280, 720};

struct Arguments {
  std::string scan = "blob:1100000";
  std::filesystem::path out;
  int pictures = 10;
};

Result<TriangleMesh> load_scan(const std::string& scan) {
  const size_t colon = scan.find(':');
  if (colon == std::string::npos) return read_mesh(scan);
  return generate_scan({scan.substr(0, colon), std::stoull(scan.substr(colon + 1))});
}

double cpu_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// A renderer with the scan's pages.
struct Stage {
  PageRenderer& renderer;
  std::vector<PatchRange> patches;

  static Result<Stage> create(PageRenderer& renderer, const RawPages& raw) {
    ASSIGN_OR_RETURN(auto patches, upload_pages(raw, renderer));
    return Stage{renderer, std::move(patches)};
  }
  Status draw(const Camera& camera, const DrawStyle& style) const {
    return renderer.draw(camera, kSize, style, patches);
  }
  Result<Image> picture(const Camera& camera, const DrawStyle& style) const {
    RETURN_IF_ERROR(draw(camera, style));
    return renderer.read_pixels();
  }
};

/// A line of the table.
struct Way {
  const char* name;
  const Stage* stage;
  int pictures;
  DrawStyle style;
};

Status add_line(const Way& way, Camera camera, const Image& expected,
                const std::filesystem::path& out) {
  ASSIGN_OR_RETURN(const Image image, way.stage->picture(camera, way.style));
  if (!out.empty()) RETURN_IF_ERROR(write_png(image, out / (std::string(way.name) + ".png")));
  Status status;
  const double before = cpu_milliseconds();
  const double wall = median_milliseconds(way.pictures, 0, [&] {
    camera = turned(camera, 1, 0);
    const Status drawn = way.stage->draw(camera, way.style);
    if (!drawn.is_ok()) status = drawn;
    glFinish();
  });
  const double cpu = (cpu_milliseconds() - before) / way.pictures;
  std::printf("%-36s %9.1f %9.1f %9.1f %9.3f\n", way.name, wall, cpu, 1000 / wall,
              100 * picture_rmse(image, expected));
  return status;
}

Status run(const Arguments& arguments) {
  ASSIGN_OR_RETURN(const TriangleMesh mesh, load_scan(arguments.scan));
  const RawPages raw = make_raw_pages(mesh);
  ASSIGN_OR_RETURN(const auto context, EglContext::create());
  ASSIGN_OR_RETURN(const auto renderer, GlPageRenderer::create());
  RasterPageRenderer one(1), two(2);
  ASSIGN_OR_RETURN(const Stage by_gl, Stage::create(*renderer, raw));
  ASSIGN_OR_RETURN(const Stage by_one, Stage::create(one, raw));
  ASSIGN_OR_RETURN(const Stage by_two, Stage::create(two, raw));
  const Camera camera =
      frame_all({.azimuth_degrees = 25, .elevation_degrees = 20}, raw.box, kSize.aspect());
  DrawStyle plain, occluded, colours;
  occluded.lighting.occlusion = 0.5;
  colours.colouring = Colouring::kScan;
  ASSIGN_OR_RETURN(const Image expected, by_gl.picture(camera, plain));
  ASSIGN_OR_RETURN(const Image dark, by_gl.picture(camera, occluded));
  std::printf("%s: %zu triangles, %dx%d, beside %s\n", arguments.scan.c_str(),
              mesh.triangles.size(), kSize.width, kSize.height,
              reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
  std::printf("%-36s %9s %9s %9s %9s\n", "", "ms", "CPU ms", "a second", "RMSE %");
  for (const RasterSampling sampling : {RasterSampling::kOne, RasterSampling::kFour}) {
    one.set_sampling(sampling);
    two.set_sampling(sampling);
    const bool is_one = sampling == RasterSampling::kOne;
    for (const Way& way : {Way{is_one ? "1 sample, 1 thread" : "4 samples, 1 thread", &by_one,
                               arguments.pictures, plain},
                           Way{is_one ? "1 sample, 2 threads" : "4 samples, 2 threads", &by_two,
                               arguments.pictures, plain}})
      RETURN_IF_ERROR(add_line(way, camera, expected, arguments.out));
  }
  RETURN_IF_ERROR(add_line({"4 samples, 2 threads, occlusion", &by_two, 3, occluded}, camera, dark,
                           arguments.out));
  return add_line({"OpenGL", &by_gl, 2, plain}, camera, expected, arguments.out);
}

}  // namespace
}  // namespace burnish

int main(int count, char** words) {
  burnish::Arguments arguments;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--out" && i + 1 < count) {
      arguments.out = words[++i];
    } else if (word == "--pictures" && i + 1 < count) {
      arguments.pictures = std::stoi(words[++i]);
    } else {
      arguments.scan = word;
    }
  }
  const burnish::Status status = burnish::run(arguments);
  if (!status.is_ok()) std::fprintf(stderr, "raster_bench: %s\n", status.message().c_str());
  return status.is_ok() ? 0 : 1;
}
