#include "tests/server/prepare/sheets/sheets_of_ball.h"

#include <array>
#include <cmath>
#include <random>

#include "common/base/check.h"
#include "common/mesh/io/mesh_io.h"
#include "common/mesh/io/textured_surface.h"
#include "common/mesh/statistics/statistics.h"
#include "common/pages/directory_codec.h"
#include "server/prepare/pages/build_pages.h"
#include "server/prepare/sheets/count_texels.h"

namespace burnish {

namespace {

/// Returns a sheet's colour at a place, 0 to 255.
Vec3d shown_at(const Sheet& sheet, const Vec2d& at) {
  const Vec2d first = (at - Vec2d::Constant(0.5)).array().floor();
  const Vec2d part = at - Vec2d::Constant(0.5) - first;
  Vec3d sum = Vec3d::Zero();
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 2; ++x) {
      const auto column = static_cast<size_t>(first.x()) + x;
      const auto row = static_cast<size_t>(first.y()) + y;
      const Rgba8& texel = sheet.texels.at(row * sheet.layout.width + column);
      const double weight = (x == 0 ? 1 - part.x() : part.x()) * (y == 0 ? 1 - part.y() : part.y());
      sum += weight * Vec3d(texel[0], texel[1], texel[2]);
    }
  return sum;
}

/// Sums the squared differences of one page.
class PageDifference {
 public:
  PageDifference(const ColourAt& pattern, const PageGrid& grid) : pattern_(pattern), grid_(grid) {}

  void add(const Page& page, const PageCharts& charts, const Sheet& sheet) {
    for (size_t t = 0; t < page.triangles.size(); ++t) {
      const size_t chart = charts.of_triangle[t];
      const ChartMapping map = chart_mapping(charts.charts[chart], sheet.density * grid_.step(),
                                             sheet.layout.places[chart]);
      for (int sample = 0; sample < 4; ++sample)
        add_place(place_on(page, t), map, sheet, area_of(page, t));
    }
  }

  double psnr() const { return 10 * std::log10(255.0 * 255.0 * 3 * areas_ / squares_); }

 private:
  Vec3d place_on(const Page& page, size_t triangle) {
    const double root = std::sqrt(part_(random_));
    const double side = part_(random_);
    const Vec3d weights(1 - root, root * (1 - side), root * side);
    Vec3d place = Vec3d::Zero();
    for (int k = 0; k < 3; ++k)
      place += weights[k] * page.positions[page.triangles[triangle][k]].cast<double>();
    return place;
  }

  static double area_of(const Page& page, size_t triangle) {
    std::array<Vec3d, 3> corners;
    for (int k = 0; k < 3; ++k)
      corners[k] = page.positions[page.triangles[triangle][k]].cast<double>();
    return (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
  }

  void add_place(const Vec3d& place, const ChartMapping& map, const Sheet& sheet, double area) {
    const Vec3d position = grid_.origin + (place + Vec3d::Constant(0.5)) * grid_.step();
    const auto colour = pattern_(position);
    if (!colour) return;
    const Vec3d wanted((*colour)[0], (*colour)[1], (*colour)[2]);
    squares_ += area * (shown_at(sheet, map.texel(place)) - wanted).squaredNorm();
    areas_ += area;
  }

  const ColourAt& pattern_;
  const PageGrid& grid_;
  std::mt19937 random_{1};
  std::uniform_real_distribution<double> part_{0, 1};
  double squares_ = 0;
  double areas_ = 0;
};

}  // namespace

static PageFile pages_of(std::span<const uint8_t> zip, const std::filesystem::path& path,
                         const PageTexels& texels) {
  const TriangleMesh mesh = read_mesh(zip, MeshFormat::kZip, "ball").value();
  const MeshStatistics statistics = compute_statistics(mesh);
  const Status built =
      build_pages({mesh.vertices, mesh.triangles, mesh.colours, statistics, texels}, path);
  BURNISH_CHECK(built.is_ok(), built.message());
  return PageFile::open(path).value();
}

PageFile full_pages_of_archive(std::span<const uint8_t> zip, const std::filesystem::path& path) {
  return pages_of(zip, path, {});
}

PageFile pages_of_archive(std::span<const uint8_t> zip, const std::filesystem::path& path) {
  CountedTexels texels;
  const auto count = [&](const TexturedSurface& surface) -> Status {
    ASSIGN_OR_RETURN(texels, count_texels(surface.textures, "ball", {}, {}));
    return Status::ok();
  };
  const Status counted = read_textured_surface(zip, MeshFormat::kZip, "ball", count);
  BURNISH_CHECK(counted.is_ok(), counted.message());
  return pages_of(zip, path, texels.for_pages());
}

Result<bool> build_sheets_of_archive(std::span<const uint8_t> zip, const PageFile& pages,
                                     const std::filesystem::path& path,
                                     const SheetsOptions& options, const Progress& progress,
                                     SheetsReport* report) {
  bool has_sheets = false;
  RETURN_IF_ERROR(read_textured_surface(
      zip, MeshFormat::kZip, "ball", [&](const TexturedSurface& surface) -> Status {
        ASSIGN_OR_RETURN(has_sheets,
                         build_sheets({surface, pages, "ball"}, path, options, progress, report));
        return Status::ok();
      }));
  return has_sheets;
}

double psnr_of_level(const PaintedBall& ball, const PageFile& pages, const SheetFile& sheets,
                     int level) {
  const auto pattern = [&](const Vec3d& position) { return ball.colour_at(position); };
  return psnr_of_level(ColourAt(pattern), pages, sheets, level);
}

double psnr_of_level(const ColourAt& pattern, const PageFile& pages, const SheetFile& sheets,
                     int level) {
  const PageHead& head = pages.directory().head;
  PageDifference difference(pattern, head.grid);
  for (PageId id = head.level_begin(level); id < head.level_begin(level + 1); ++id) {
    const Page page = pages.read_page(id).value();
    difference.add(page, sheets.read_charts(page).value(), sheets.read_sheet(id, 0).value());
  }
  return difference.psnr();
}

/// Returns the weights of a triangle's corners at a place, seen along z; steps.
static Vec3d weights_at(const Page& page, const PageTriangle& triangle, const Vec2d& place) {
  std::array<Vec2d, 3> corners;
  for (int k = 0; k < 3; ++k)
    corners[k] = page.positions[triangle[k]].cast<double>().head<2>() - place;
  const auto area = [&](int a, int b) {
    return corners[a].x() * corners[b].y() - corners[a].y() * corners[b].x();
  };
  const Vec3d areas(area(1, 2), area(2, 0), area(0, 1));
  return areas / areas.sum();
}

Vec3d colour_above(const PageFile& pages, const SheetFile& sheets, double x, double y) {
  const PageHead& head = pages.directory().head;
  const Vec2d steps =
      (Vec2d(x, y) - head.grid.origin.head<2>()) / head.grid.step() - Vec2d::Constant(0.5);
  for (PageId id = 0; id < head.level_begin(1); ++id) {
    const Page page = pages.read_page(id).value();
    for (size_t t = 0; t < page.triangles.size(); ++t) {
      const Vec3d weights = weights_at(page, page.triangles[t], steps);
      if (!(weights.minCoeff() >= 0)) continue;
      const PageCharts charts = sheets.read_charts(page).value();
      const Sheet sheet = sheets.read_sheet(id, 0).value();
      Vec3d place = Vec3d::Zero();
      for (int k = 0; k < 3; ++k)
        place += weights[k] * page.positions[page.triangles[t][k]].cast<double>();
      const size_t chart = charts.of_triangle[t];
      const ChartMapping map = chart_mapping(charts.charts[chart], sheet.density * head.grid.step(),
                                             sheet.layout.places[chart]);
      return shown_at(sheet, map.texel(place));
    }
  }
  BURNISH_CHECK(false, "no triangle is there");
  return Vec3d::Zero();
}

SheetFile open_sheets(const std::filesystem::path& path, const PageFile& pages) {
  return SheetFile::open(path, pages.directory().head, pages_fingerprint(pages.head_bytes()))
      .value();
}

}  // namespace burnish
