// Pictures of the settled cut beside those of the whole scan: the whole view and three zooms.
// cut_pictures [--out FOLDER] SCAN...   writes the pairs as PNG files into the folder

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <unistd.h>

#include "client/gl/context_egl.h"
#include "client/gl/gl_page_renderer.h"
#include "client/pages/cut_status.h"
#include "client/pages/drawn_ranges.h"
#include "client/scene/png_writer.h"
#include "client/scene/raw_pages.h"
#include "tests/bench/bench_main.h"
#include "tests/bench/local_pages.h"
#include "tests/bench/picture_difference.h"
#include "tests/server/prepare/pages/read_pages.h"

namespace burnish {
namespace {

constexpr ImageSize kPictureSize{1280, 720};
constexpr double kZooms[] = {1, 2, 5, 15};
constexpr int kDepthOfNoMatter = 8;  // nothing moves

/// The place of a page file, which goes with this object.
struct ScratchPages {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("burnish-cut-pictures-" + std::to_string(getpid()));

  ~ScratchPages() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
};

/// The whole scan, drawn as it is.
class WholeScan {
 public:
  static Result<std::unique_ptr<WholeScan>> create(const TriangleMesh& mesh) {
    auto whole = std::make_unique<WholeScan>();
    ASSIGN_OR_RETURN(whole->renderer_, GlPageRenderer::create());
    const RawPages raw = make_raw_pages(mesh);
    whole->box = raw.box;
    ASSIGN_OR_RETURN(whole->patches_, upload_pages(raw, *whole->renderer_));
    return whole;
  }
  Result<Image> draw(const Camera& camera) {
    RETURN_IF_ERROR(renderer_->draw(camera, kPictureSize, {}, patches_));
    return renderer_->read_pixels();
  }

  Eigen::AlignedBox3d box;

 private:
  std::unique_ptr<GlPageRenderer> renderer_;
  std::vector<PatchRange> patches_;
};

/// The scan's pages, drawn as a client draws them that has all the time of the world.
class CutScan {
 public:
  static Result<std::unique_ptr<CutScan>> create(const std::filesystem::path& path) {
    ASSIGN_OR_RETURN(PageFile file, PageFile::open(path));
    auto cut = std::make_unique<CutScan>(std::move(file));
    ASSIGN_OR_RETURN(cut->renderer_, GlPageRenderer::create());
    const PageHead& head = cut->pages_.head();
    cut->renderer_->open(make_page_space(head.grid, kDepthOfNoMatter));
    RETURN_IF_ERROR(cut->renderer_->reserve(
        static_cast<uint32_t>(std::min<uint64_t>(PageBudget().slots(), head.page_count()))));
    return cut;
  }
  explicit CutScan(PageFile file) : pages_(std::move(file)) {}

  Result<Image> draw(const Camera& camera) {
    RETURN_IF_ERROR(settle(make_page_view(camera, kPictureSize, pages_.head().grid)));
    std::vector<PatchRange> patches;
    const PageLoader& loader = pages_.loader();
    for (const DrawnRange& range : drawn_ranges(loader.cut(), loader.cache()))
      patches.push_back({range.slot, range.first_triangle, range.triangles});
    RETURN_IF_ERROR(renderer_->draw(camera, kPictureSize, {}, patches));
    return renderer_->read_pixels();
  }
  CutStatus status() const { return pages_.loader().status(); }

 private:
  Status settle(const PageView& view) {
    for (int look = 0; look < 10'000; ++look) {
      ASSIGN_OR_RETURN(const std::vector<PageUpload> uploads, pages_.look(view));
      for (const PageUpload& upload : uploads)
        RETURN_IF_ERROR(renderer_->upload_page(
            upload.slot, make_page_mesh(*upload.content, pages_.head().grid)));
      if (pages_.loader().is_settled()) return Status::ok();
    }
    return internal_error("the cut does not settle: " + status_text(status()));
  }

  LocalPages pages_;
  std::unique_ptr<GlPageRenderer> renderer_;
};

/// Returns a camera that looks at what lies in the middle of the whole view, from nearer.
Camera zoomed_in(const Camera& whole, const Vec3d& target, double zoom) {
  Camera camera = whole;
  if (zoom > 1) camera.target = target;
  camera.distance = whole.distance / zoom;
  return camera;
}

// The vertex that is nearest to the camera among those near the middle of the picture.
Vec3d point_in_the_middle(const TriangleMesh& mesh, const Camera& camera, double diagonal) {
  const Eigen::Matrix3d axes = camera_axes(camera);
  const double near_middle = 0.03 * diagonal;
  Vec3d best = camera.target;
  double nearest = -std::numeric_limits<double>::infinity();
  for (const Vec3d& vertex : mesh.vertices) {
    const Vec3d seen = axes * (vertex - camera.target);
    if (seen.head<2>().norm() > near_middle || seen.z() < nearest) continue;
    nearest = seen.z();
    best = vertex;
  }
  return best;
}

Status write_pair(const std::filesystem::path& out, const std::string& name, const Image& cut,
                  const Image& whole, const PictureDifference& difference) {
  if (out.empty()) return Status::ok();
  RETURN_IF_ERROR(write_png(cut, out / (name + "-cut.png")));
  RETURN_IF_ERROR(
      write_png(picture_close_up(cut, whole, difference.blob_place), out / (name + "-close.png")));
  return write_png(whole, out / (name + "-whole.png"));
}

std::string file_name(std::string name) {
  std::ranges::replace_if(
      name, [](char c) { return c == ':' || c == '/' || c == '@'; }, '-');
  return name;
}

Status compare_scan(const ScanArgument& scan, const BenchArguments& arguments, BenchTable& table) {
  ASSIGN_OR_RETURN(const TriangleMesh mesh, load_mesh(scan));
  const ScratchPages file;
  RETURN_IF_ERROR(build_pages_of(mesh, file.path));
  ASSIGN_OR_RETURN(const auto whole, WholeScan::create(mesh));
  ASSIGN_OR_RETURN(const auto cut, CutScan::create(file.path));
  const Camera far = frame_all({.azimuth_degrees = 25, .elevation_degrees = 20}, whole->box,
                               kPictureSize.aspect());
  const Vec3d target = point_in_the_middle(mesh, far, whole->box.diagonal().norm());
  for (const double zoom : kZooms) {
    const Camera camera = with_depth_of(zoomed_in(far, target, zoom), whole->box);
    ASSIGN_OR_RETURN(const Image cut_picture, cut->draw(camera));
    ASSIGN_OR_RETURN(const Image whole_picture, whole->draw(camera));
    const PictureDifference difference = compare_pictures(cut_picture, whole_picture);
    const CutStatus status = cut->status();
    table.add({scan.name(), zoom, static_cast<double>(status.triangles_drawn),
               static_cast<double>(status.triangles_in_view),
               std::string(status.is_full_detail ? "full" : "coarser"), difference.mean,
               static_cast<double>(difference.largest_blob)});
    RETURN_IF_ERROR(write_pair(
        arguments.out, file_name(scan.name()) + "-" + std::to_string(static_cast<int>(zoom)),
        cut_picture, whole_picture, difference));
  }
  return Status::ok();
}

Status run(const BenchArguments& arguments, BenchReport& report) {
  ASSIGN_OR_RETURN(const auto context, EglContext::create());
  BenchTable& table = report.add_table("cut_pictures", {{"scan", "", 18},
                                                        {"zoom", "%.0f"},
                                                        {"drawn", "%.0f"},
                                                        {"in_view", "%.0f"},
                                                        {"detail", "", 8},
                                                        {"mean_difference", "%.3f"},
                                                        {"largest_blob", "%.0f"}});
  for (const ScanArgument& scan : arguments.scans)
    RETURN_IF_ERROR(compare_scan(scan, arguments, table));
  return Status::ok();
}

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
  return burnish::bench_main(
      {"cut_pictures", {"tablet:400000", "blob:400000", "soup:100000"}, burnish::run}, argc, argv);
}
