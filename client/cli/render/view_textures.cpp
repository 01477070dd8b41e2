#include "client/cli/render/view_textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "client/pages/page_view.h"
#include "client/sheets/opened_texture.h"
#include "client/sheets/sheet_choice.h"
#include "common/base/heard_loop.h"
#include "common/mesh/textures/shown_picture.h"
#include "common/sheets/sheet_density.h"
#include "server/prepare/sheets/page_paint.h"
#include "server/prepare/sheets/painted_sheets.h"
#include "server/prepare/sheets/parallel_pages.h"

namespace burnish {

namespace {

// Charts cover about half of a sheet, whose side is at most kSheetSideMax.
constexpr double kTexelsPerPageMax = 512 * 512;
constexpr double kCoveredPart = 0.5;
constexpr double kBytesPerTexel = sizeof(Rgba8) * (1 + 1 / 4.0 + 1 / 16.0) / kCoveredPart;
constexpr int kHalvingsMax = 12;

/// The lattice over the space of raw pages.
PageGrid grid_of(const PageSpace& space) {
  return {.origin = space.centre - Vec3d::Constant(space.unit), .side = 2 * space.unit};
}

template <typename Corners>
double area_between(const Corners& corners) {
  const auto a = corners[1] - corners[0], b = corners[2] - corners[0];
  return std::sqrt(std::max(0.0, a.squaredNorm() * b.squaredNorm() - a.dot(b) * a.dot(b))) / 2;
}

/// Returns the sphere around some points.
template <typename Points, typename PlaceOf>
PageBounds bounds_around(const Points& points, const PlaceOf& place_of) {
  Eigen::AlignedBox3f box;
  for (const auto& point : points) box.extend(place_of(point));
  PageBounds bounds{.centre = box.center()};
  for (const auto& point : points)
    bounds.radius = std::max(bounds.radius, (place_of(point) - bounds.centre).norm());
  return bounds;
}

Page page_of(const PageMesh& mesh, const PageSpace& space, const PageGrid& grid) {
  Page page;
  page.patches = {{kNoPage, static_cast<uint32_t>(mesh.triangles.size())}};
  page.triangles = mesh.triangles;
  page.positions.reserve(mesh.positions.size());
  for (const Vec3f& position : mesh.positions)
    page.positions.push_back(grid.quantise(space.to_file(position)));
  return page;
}

/// The texels of one triangle.
struct TriangleNeed {
  float shown = 0;   ///< that the picture needs where it is; outside it, too
  float native = 0;  ///< that the scan's pictures have
  bool is_visible = false;

  float texels(int halvings) const { return std::min(std::ldexp(shown, -2 * halvings), native); }
};

/// Makes the textures of one picture.
class ViewBaker {
 public:
  ViewBaker(const TexturedSurface& surface, const PictureTiles& tiles, const ViewWish& wish)
      : surface_(surface),
        tiles_(tiles),
        space_(raw_page_space(referenced_box(surface.mesh))),
        grid_(grid_of(space_)),
        view_(make_page_view(wish.camera, wish.size, grid_)) {}

  std::vector<TriangleNeed> needs() const {
    std::vector<TriangleNeed> needs(surface_.mesh.triangles.size());
    parallel_for_heard(kUnheardLoop, needs.size(),
                       [&](size_t t) { needs[t] = need_of(static_cast<uint32_t>(t)); });
    return needs;
  }

  // A page at the picture's border has a sheet for all of its triangles.
  RawPages cut(std::span<const TriangleNeed> needs, int halvings) const {
    std::vector<float> texels;
    texels.reserve(needs.size());
    for (const TriangleNeed& need : needs) texels.push_back(need.texels(halvings));
    return make_raw_pages(surface_.mesh, texels, kTexelsPerPageMax);
  }

  Status bake(ViewTextures& made) const {
    const size_t count = made.raw.pages.size();
    std::vector<size_t> begins;  // of the pages' triangles
    size_t begin = 0;
    for (const PageMesh& page : made.raw.pages)
      begins.push_back(std::exchange(begin, begin + page.triangles.size()));
    std::vector<Status> statuses(count);
    made.of_page.assign(count, nullptr);
    LoopProgress loop(kNoProgress, {}, 0, 1);
    parallel_pages(0, count, count, loop, [&](size_t i, const auto&) {
      const PageMesh& mesh = made.raw.pages[i];
      const std::span numbers(made.raw.triangles.data() + begins[i], mesh.triangles.size());
      auto texture = texture_of(mesh, numbers, made.halvings);
      statuses[i] = texture.status();
      if (texture.is_ok()) made.of_page[i] = std::move(*texture);
    });
    for (const Status& status : statuses) RETURN_IF_ERROR(status);
    return Status::ok();
  }

 private:
  Vec3f from_origin(const Vec3d& place) const { return (place - grid_.origin).cast<float>(); }

  TriangleNeed need_of(uint32_t triangle) const {
    std::array<Vec3d, 3> corners;
    for (int k = 0; k < 3; ++k)
      corners[k] = surface_.mesh.vertices[surface_.mesh.triangles[triangle][k]];
    const PageBounds bounds =
        bounds_around(corners, [&](const Vec3d& place) { return from_origin(place); });
    const double density = needed_density(view_, bounds, 0, kTexelsPerPixelStill);
    return {static_cast<float>(area_between(corners) * density * density),
            static_cast<float>(native_texels(triangle)), is_visible(view_, bounds, 0)};
  }

  double native_texels(uint32_t triangle) const {
    const uint32_t picture = shown_picture(surface_.textures, triangle);
    if (picture == kNoTexture || !tiles_.has(picture)) return kTexelsPerEdge * kTexelsPerEdge / 2;
    const TiledLevel& level = tiles_.levels(picture).front();
    return area_on_picture(surface_.textures, triangle) * level.width * level.height;
  }

  Result<std::shared_ptr<const PageTexture>> texture_of(const PageMesh& mesh,
                                                        std::span<const uint32_t> triangles,
                                                        int halvings) const {
    const PageBounds bounds = bounds_around(mesh.positions, [&](const Vec3f& position) {
      return from_origin(space_.to_file(position));
    });
    if (!is_visible(view_, bounds, 0)) return std::shared_ptr<const PageTexture>();
    const float needed = needed_density(view_, bounds, 0, kTexelsPerPixelStill);
    const Page page = page_of(mesh, space_, grid_);
    const PagePaint paint(page, surface_, tiles_, triangles);
    ASSIGN_OR_RETURN(
        PageSheets made,
        make_painted_sheets(
            page, paint, tiles_,
            {.step = grid_.step(), .density_max = std::ldexp(needed, -halvings), .sheets_max = 1}));
    return std::make_shared<const PageTexture>(
        make_page_texture(page, made.charts, std::move(made.sheets.front()), grid_));
  }

  const TexturedSurface& surface_;
  const PictureTiles& tiles_;
  const PageSpace space_;
  const PageGrid grid_;
  const PageView view_;
};

/// Returns how many bytes these textures are likely to take.
double predicted_bytes(std::span<const TriangleNeed> needs, int halvings) {
  double texels = 0;
  for (const TriangleNeed& need : needs)
    if (need.is_visible) texels += need.texels(halvings);
  return texels * kBytesPerTexel;
}

uint64_t bytes_of(const ViewTextures& made) {
  uint64_t bytes = 0;
  for (const auto& texture : made.of_page) bytes += texture ? texture->bytes() : 0;
  return bytes;
}

}  // namespace

Result<ViewTextures> bake_view_textures(const TexturedSurface& surface, const PictureTiles& tiles,
                                        const ViewWish& wish) {
  const ViewBaker baker(surface, tiles, wish);
  const std::vector<TriangleNeed> needs = baker.needs();
  const auto bytes_max = static_cast<double>(wish.bytes_max);
  ViewTextures made;
  while (predicted_bytes(needs, made.halvings) > bytes_max && made.halvings < kHalvingsMax)
    ++made.halvings;
  for (;; ++made.halvings) {
    made.raw = baker.cut(needs, made.halvings);
    RETURN_IF_ERROR(baker.bake(made));
    if (bytes_of(made) <= wish.bytes_max) return made;
    if (made.halvings >= kHalvingsMax)
      return resource_exhausted("the textures of a picture take " + std::to_string(bytes_of(made)) +
                                " bytes at least: the limit is " + std::to_string(wish.bytes_max));
  }
}

}  // namespace burnish
