// Measures pictures that processors draw (client/raster) beside those of OpenGL, turning around a
// scan at full detail:
// raster_bench [--pictures N] [--threads N]... [--out FOLDER] [SCAN]
//
// SCAN is a mesh file or KIND:VERTICES. The difference is the root of the mean square, as a part of
// the full range, to OpenGL's picture of the same view. Without a driver there is no such column.

#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <epoxy/gl.h>

#include "client/gl/context_egl.h"
#include "client/gl/gl_page_renderer.h"
#include "client/raster/raster_page_renderer.h"
#include "client/scene/png_writer.h"
#include "client/scene/raw_pages.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/bench/timing.h"
#include "tests/client/raster/picture_rmse.h"

namespace burnish {
namespace {

constexpr ImageSize kSize{1280, 720};

struct Arguments {
  std::string scan = "blob:1100000";
  std::filesystem::path out;
  int pictures = 10;
  std::vector<int> threads = {1, 2};
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
  PageRenderer* renderer = nullptr;
  std::vector<PatchRange> patches;

  static Result<Stage> create(PageRenderer& renderer, const RawPages& raw) {
    ASSIGN_OR_RETURN(auto patches, upload_pages(raw, renderer));
    return Stage{&renderer, std::move(patches)};
  }
  Status draw(const Camera& camera, const DrawStyle& style) const {
    return renderer->draw(camera, kSize, style, patches);
  }
  Result<Image> picture(const Camera& camera, const DrawStyle& style) const {
    RETURN_IF_ERROR(draw(camera, style));
    return renderer->read_pixels();
  }
};

struct Way {
  std::string name;
  const Stage* stage;
  int pictures;
  DrawStyle style;
};

/// A line of the table. `expected`: OpenGL's picture, or null without a driver.
Status add_line(const Way& way, Camera camera, const Image* expected,
                const std::filesystem::path& out) {
  ASSIGN_OR_RETURN(const Image image, way.stage->picture(camera, way.style));
  if (!out.empty()) RETURN_IF_ERROR(write_png(image, out / (way.name + ".png")));
  Status status;
  const double before = cpu_milliseconds();
  const double wall = median_milliseconds(way.pictures, 0, [&] {
    camera = turned(camera, 1, 0);
    const Status drawn = way.stage->draw(camera, way.style);
    if (!drawn.is_ok()) status = drawn;
    if (expected != nullptr) glFinish();
  });
  const double cpu = (cpu_milliseconds() - before) / way.pictures;
  std::printf("%-36s %9.1f %9.1f %9.1f", way.name.c_str(), wall, cpu, 1000 / wall);
  if (expected != nullptr) std::printf(" %9.3f", 100 * picture_rmse(image, *expected));
  std::printf("\n");
  return status;
}

DrawStyle occluded_style() {
  DrawStyle style;
  style.lighting.occlusion = 0.5;
  return style;
}

/// OpenGL's pictures, where there is a driver.
struct GlPictures {
  std::unique_ptr<EglContext> context;
  std::unique_ptr<GlPageRenderer> renderer;
  std::optional<Stage> stage;
  std::optional<Image> plain, occluded;

  Status draw(const RawPages& raw, const Camera& camera) {
    auto made = EglContext::create();
    if (!made.is_ok()) return Status::ok();
    context = std::move(made).value();
    ASSIGN_OR_RETURN(renderer, GlPageRenderer::create());
    ASSIGN_OR_RETURN(stage, Stage::create(*renderer, raw));
    ASSIGN_OR_RETURN(plain, stage->picture(camera, {}));
    ASSIGN_OR_RETURN(occluded, stage->picture(camera, occluded_style()));
    std::printf("beside %s\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    return Status::ok();
  }
};

const Image* expected_of(const std::optional<Image>& picture) {
  return picture ? &*picture : nullptr;
}

Status run(const Arguments& arguments) {
  ASSIGN_OR_RETURN(const TriangleMesh mesh, load_scan(arguments.scan));
  const RawPages raw = make_raw_pages(mesh);
  const Camera camera =
      frame_all({.azimuth_degrees = 25, .elevation_degrees = 20}, raw.box, kSize.aspect());
  std::printf("%s: %zu triangles, %dx%d\n", arguments.scan.c_str(), mesh.triangles.size(),
              kSize.width, kSize.height);
  GlPictures gl;
  RETURN_IF_ERROR(gl.draw(raw, camera));
  std::printf("%-36s %9s %9s %9s %9s\n", "", "ms", "CPU ms", "a second", "RMSE %");
  for (const int threads : arguments.threads) {
    RasterPageRenderer renderer(threads);
    ASSIGN_OR_RETURN(const Stage stage, Stage::create(renderer, raw));
    const std::string with = std::to_string(threads) + " threads, ";
    renderer.set_sampling(RasterSampling::kOne);
    RETURN_IF_ERROR(add_line({with + "1 sample", &stage, arguments.pictures, {}}, camera,
                             expected_of(gl.plain), arguments.out));
    renderer.set_sampling(RasterSampling::kFour);
    RETURN_IF_ERROR(add_line({with + "4 samples", &stage, arguments.pictures, {}}, camera,
                             expected_of(gl.plain), arguments.out));
    RETURN_IF_ERROR(
        add_line({with + "4 samples, occlusion", &stage, arguments.pictures, occluded_style()},
                 camera, expected_of(gl.occluded), arguments.out));
  }
  if (!gl.stage) return Status::ok();
  return add_line({"OpenGL", &*gl.stage, 2, {}}, camera, expected_of(gl.plain), arguments.out);
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
    } else if (word == "--threads" && i + 1 < count) {
      arguments.threads.push_back(std::stoi(words[++i]));
    } else {
      arguments.scan = word;
    }
  }
  const burnish::Status status = burnish::run(arguments);
  if (!status.is_ok()) std::fprintf(stderr, "raster_bench: %s\n", status.message().c_str());
  return status.is_ok() ? 0 : 1;
}
